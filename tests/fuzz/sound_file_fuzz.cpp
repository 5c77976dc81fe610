// Sound file: an error that names it, or finite samples near full scale, which the mixer plays.
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "hal/audio/mixer.hpp"
#include "hal/audio/program/sound_file.hpp"

namespace {

using namespace darwinop::audio;

constexpr std::size_t kMostFrames = 20'000;  // so that a second has many inputs

void require(bool holds) {
  if (!holds) std::abort();
}

/// A file in memory.
class MemoryFile {
 public:
  MemoryFile(const std::uint8_t* data, std::size_t size) : file_{memfd_create("sound", MFD_CLOEXEC)} {
    require(file_ >= 0 && write(file_, data, size) == static_cast<ssize_t>(size));
  }
  ~MemoryFile() { close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  [[nodiscard]] std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }

 private:
  int file_;
};

void readSome(SoundSource& source) {
  std::array<AudioFrame, 512> frames{};
  for (std::size_t count = 0; count < kMostFrames;) {
    const std::size_t read = source.read(frames);
    if (read == 0) return require(source.ended());
    require(read <= frames.size());
    for (std::size_t i = 0; i < read; ++i)
      for (const float value : {frames[i].left, frames[i].right}) require(std::abs(value) <= kLoudestSample);
    count += read;
  }
}

void mixSome(std::unique_ptr<SoundSource> source) {
  Mixer mixer;
  require(mixer.play({.id = 1, .file = "sound", .pitch = 2}, std::move(source)));
  std::array<Sample, 512> block{};
  for (int i = 0; i < 8; ++i) mixer.mix(block);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const MemoryFile file{data, size};
  try {
    SoundFile sound = openSoundFile(file.path());
    require(std::isnan(sound.seconds) || sound.seconds > 0);
    require(sound.source->rate() > 0);
    readSome(*sound.source);
    if (sound.source->rewind()) mixSome(std::move(sound.source));
  } catch (const std::runtime_error& refused) {
    require(std::string_view{refused.what()}.starts_with(kCannotPlaySoundFile));
  }
  return 0;
}
