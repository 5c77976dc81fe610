// Sound files of real encoders, invalid files, and all documented voices.
#include <gmock/gmock.h>
#include <sndfile.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include "hal/audio/mixer.hpp"
#include "hal/audio/program/sound_file.hpp"
#include "hal/audio/program/speech.hpp"
#include "hal/audio/voice_names.hpp"
#include "support/temporary_folder.hpp"
#include "support/wave.hpp"

namespace darwinop::audio {
namespace {

using testing::IsEmpty;
using testing::StartsWith;

/// Stereo floating-point samples, as they are.
std::string rawWave(const std::string& name, const std::vector<float>& samples) {
  SF_INFO info{};
  info.samplerate = kMixRate;
  info.channels = 2;
  info.format = SF_FORMAT_WAV | SF_FORMAT_FLOAT;
  SNDFILE* const file = sf_open(name.c_str(), SFM_WRITE, &info);
  sf_write_float(file, samples.data(), static_cast<sf_count_t>(samples.size()));
  sf_close(file);
  return name;
}

/// 0.5 s of 441 Hz on the left and 882 Hz on the right.
std::string encoded(const TemporaryFolder& folder, int format, int rate) {
  std::string name = folder / "sound";
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = 2;
  info.format = format;
  SNDFILE* const file = sf_open(name.c_str(), SFM_WRITE, &info);
  const auto left = tone(441, 0.5, 0.5, rate), right = tone(882, 0.5, 0.5, rate);
  std::vector<float> both;
  for (std::size_t i = 0; i < left.size(); ++i)
    for (const std::int16_t side : {left[i], right[i]}) both.push_back(static_cast<float>(side) / 32768.0F);
  sf_writef_float(file, both.data(), static_cast<sf_count_t>(left.size()));
  sf_close(file);
  return name;
}

std::string rejection(const std::string& file) {
  try {
    static_cast<void>(openSoundFile(file));
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(SoundFiles, AreReadInEveryFormat) {
  for (const int format :
       {SF_FORMAT_WAV | SF_FORMAT_PCM_U8, SF_FORMAT_WAV | SF_FORMAT_PCM_16, SF_FORMAT_WAV | SF_FORMAT_FLOAT,
        SF_FORMAT_WAV | SF_FORMAT_IMA_ADPCM, SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III,
        SF_FORMAT_FLAC | SF_FORMAT_PCM_16, SF_FORMAT_OGG | SF_FORMAT_VORBIS}) {
    const TemporaryFolder folder;
    const SoundFile file = openSoundFile(encoded(folder, format, 22050));
    EXPECT_EQ(file.source->rate(), 22050);
    EXPECT_NEAR(file.seconds, 0.5, 0.11) << std::hex << format;
    std::vector<AudioFrame> frames(22050);
    frames.resize(file.source->read(frames));
    std::vector<double> left, right;
    for (const AudioFrame& frame : frames) {
      left.push_back(frame.left);
      right.push_back(frame.right);
    }
    EXPECT_NEAR(amplitudeAt(441, audiblePart(left), 22050), 0.5, 0.05) << std::hex << format;
    EXPECT_NEAR(amplitudeAt(882, audiblePart(right), 22050), 0.5, 0.05) << std::hex << format;
    EXPECT_EQ(file.source->read(frames), 0U);
    EXPECT_TRUE(file.source->ended());
    EXPECT_TRUE(file.source->rewind());
    EXPECT_GT(file.source->read(frames), 10000U) << std::hex << format;
  }
}

TEST(SoundFiles, HaveOnlyFiniteSamplesWhateverTheyStore) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  const TemporaryFolder folder;
  const SoundFile file = openSoundFile(rawWave(folder / "sound", {kNan, 1.5F, kInfinity, -kInfinity, -1e38F, 1e-45F}));
  std::vector<AudioFrame> frames(8);
  ASSERT_EQ(file.source->read(frames), 3U);
  EXPECT_EQ(frames[0].left, 0);
  EXPECT_EQ(frames[0].right, 1.5F);
  EXPECT_EQ(frames[1].left, kLoudestSample);
  EXPECT_EQ(frames[1].right, -kLoudestSample);
  EXPECT_EQ(frames[2].left, -kLoudestSample);
  EXPECT_NEAR(frames[2].right, 0, 1e-6);
}

TEST(SoundFiles, ThatStoreNoNumbersLeaveOtherSoundsAudible) {
  const TemporaryFolder folder;
  Mixer mixer;
  const std::vector<float> nothing(2000, std::numeric_limits<float>::quiet_NaN()), half(2000, 0.5F);
  ASSERT_TRUE(mixer.play({.id = 1}, openSoundFile(rawWave(folder / "nothing", nothing)).source));
  ASSERT_TRUE(mixer.play({.id = 2}, openSoundFile(rawWave(folder / "half", half)).source));
  std::vector<Sample> mixed(500);
  mixer.mix(mixed);
  for (const Sample& sample : mixed) ASSERT_NEAR(sample.left, 0.5 * 32767, 1);
}

TEST(SoundFiles, ThatAreInvalidAreNamedWithTheReason) {
  const TemporaryFolder folder;
  EXPECT_EQ(rejection(folder / "nothing"), kCannotReadSoundFile + (folder / "nothing: ") + std::strerror(ENOENT));
  EXPECT_THAT(rejection(folder / ""), StartsWith(kCannotReadSoundFile + (folder / ": ")));
  for (const std::string& text : {std::string{}, std::string(10'000, '\0'), std::string{"RIFF----WAVEfmt "},
                                  std::string{"\xFF\xFB\x90\x44 and no more"}}) {
    std::ofstream{folder / "some"} << text;
    EXPECT_THAT(rejection(folder / "some"), StartsWith(kCannotPlaySoundFile + (folder / "some: "))) << text;
  }
}

TEST(Voices, OfEveryDocumentedNameExist) {
  std::string errors;
  Speech speech{"", [&](const std::string& what) { errors += what; }};
  std::vector<AudioFrame> frames(512);
  for (const VoiceName& name : kVoiceNames) {
    const auto voice = speech.speak({.text = "1", .voice = std::string{name.said}});
    ASSERT_TRUE(voice);
    std::size_t frame_count = 0;
    while (!voice->ended()) frame_count += voice->read(frames);
    EXPECT_GT(frame_count, 1000U) << name.said;
  }
  EXPECT_THAT(errors, IsEmpty());
}

}  // namespace
}  // namespace darwinop::audio
