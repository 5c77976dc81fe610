// Sound files through libsndfile: WAV, MP3, FLAC, Ogg and others.
#include "hal/audio/program/sound_file.hpp"

#include <sndfile.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace darwinop::audio {

namespace {

constexpr int kMostChannels = 8;
constexpr int kLowestRate = 1000, kHighestRate = 384'000;  // Hz

float audible(float sample) {
  return std::isnan(sample) ? 0.0F : std::clamp(sample, -kLoudestSample, kLoudestSample);
}

struct CloseSoundFile {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

class OpenSoundFile final : public SoundSource {
 public:
  OpenSoundFile(SNDFILE* file, const SF_INFO& info) : file_{file}, info_{info} {}

  [[nodiscard]] int rate() const override { return info_.samplerate; }
  std::size_t read(std::span<AudioFrame> frames) override {
    const auto channels = static_cast<std::size_t>(info_.channels);
    samples_.resize(frames.size() * channels);
    const sf_count_t count = sf_readf_float(file_.get(), samples_.data(), static_cast<sf_count_t>(frames.size()));
    if (count <= 0) {
      ended_ = true;
      return 0;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
      const float* const frame = samples_.data() + i * channels;
      frames[i] = {audible(frame[0]), audible(frame[channels > 1 ? 1 : 0])};  // of more than two channels the first two
    }
    return static_cast<std::size_t>(count);
  }
  [[nodiscard]] bool ended() const override { return ended_; }
  bool rewind() override { return sf_seek(file_.get(), 0, SEEK_SET) == 0; }

 private:
  std::unique_ptr<SNDFILE, CloseSoundFile> file_;
  SF_INFO info_;
  std::vector<float> samples_;
  bool ended_ = false;
};

}  // namespace

SoundFile openSoundFile(const std::string& file) {
  struct stat about {};
  if (stat(file.c_str(), &about) != 0)
    throw std::runtime_error(kCannotReadSoundFile + file + ": " + std::strerror(errno));
  // Opening a FIFO would block.
  if (!S_ISREG(about.st_mode)) throw std::runtime_error(kCannotReadSoundFile + file + ": not a regular file");
  SF_INFO info{};
  SNDFILE* const open = sf_open(file.c_str(), SFM_READ, &info);
  if (open == nullptr)
    throw std::runtime_error(kCannotPlaySoundFile + file +
                             ": not a WAV, MP3, FLAC or Ogg file, or the file is damaged");
  auto source = std::make_unique<OpenSoundFile>(open, info);
  if (info.channels < 1 || info.channels > kMostChannels || info.samplerate < kLowestRate ||
      info.samplerate > kHighestRate)
    throw std::runtime_error(kCannotPlaySoundFile + file + ": unsupported format, " + std::to_string(info.channels) +
                             " channels at " + std::to_string(info.samplerate) + " Hz");
  const bool is_known = info.frames > 0 && info.frames < std::numeric_limits<sf_count_t>::max();
  return {std::move(source),
          is_known ? static_cast<double>(info.frames) / info.samplerate : std::numeric_limits<double>::quiet_NaN()};
}

}  // namespace darwinop::audio
