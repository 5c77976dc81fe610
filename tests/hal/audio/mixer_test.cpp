// Mixer: rate, pitch, volume, balance, loop, clipping and end events.
#include "hal/audio/mixer.hpp"

#include <gmock/gmock.h>

#include "support/wave.hpp"

namespace darwinop::audio {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A tone on both channels.
class ToneSource : public SoundSource {
 public:
  ToneSource(double hertz, double seconds, int rate, double amplitude = 0.5)
      : rate_{rate}, samples_{tone(hertz, seconds, amplitude, rate)} {}

  [[nodiscard]] int rate() const override { return rate_; }
  std::size_t read(std::span<AudioFrame> frames) override {
    std::size_t count = 0;
    for (; count < frames.size() && at_ < samples_.size() && !waits; ++count, ++at_) {
      const float value = static_cast<float>(samples_[at_]) / 32768.0F;
      frames[count] = {value, value};
    }
    return count;
  }
  [[nodiscard]] bool ended() const override { return at_ == samples_.size(); }
  bool rewind() override {
    at_ = 0;
    return true;
  }
  bool waits = false;  // no data yet

 private:
  int rate_;
  std::vector<std::int16_t> samples_;
  std::size_t at_ = 0;
};

std::unique_ptr<ToneSource> toneSource(double hertz = 441, double seconds = 0.1, int rate = 22050,
                                       double amplitude = 0.5) {
  return std::make_unique<ToneSource>(hertz, seconds, rate, amplitude);
}

/// Left and right samples.
std::array<std::vector<double>, 2> sidesOf(Mixer& mixer, double seconds) {
  std::vector<Sample> out(static_cast<std::size_t>(seconds * kMixRate));
  mixer.mix(out);
  std::array<std::vector<double>, 2> sides;
  for (const Sample& sample : out) {
    sides[0].push_back(sample.left / 32768.0);
    sides[1].push_back(sample.right / 32768.0);
  }
  return sides;
}

TEST(Mixer, AnySampleRateKeepsItsPitchAndDuration) {
  for (const int rate : {8000, 22050, 44100, 48000}) {
    Mixer mixer;
    ASSERT_TRUE(mixer.play({.id = 1, .file = "a"}, toneSource(441, 0.2, rate)));
    const auto left = audiblePart(sidesOf(mixer, 0.5)[0]);
    EXPECT_NEAR(static_cast<double>(left.size()) / kMixRate, 0.2, 0.002) << rate;
    EXPECT_NEAR(amplitudeAt(441, left, kMixRate), 0.5, 0.02) << rate;
    EXPECT_THAT(mixer.takeEnded(), ElementsAre(1)) << rate;
    EXPECT_TRUE(mixer.idle());
  }
}

TEST(Mixer, VolumePitchAndBalanceAreAsOrdered) {
  Mixer mixer;
  ASSERT_TRUE(mixer.play({.id = 1, .file = "a", .volume = 0.5, .pitch = 0.5, .balance = -0.5}, toneSource()));
  const auto [left, right] = sidesOf(mixer, 0.5);
  EXPECT_NEAR(static_cast<double>(audiblePart(left).size()) / kMixRate, 0.2, 0.002);
  EXPECT_NEAR(amplitudeAt(220.5, audiblePart(left), kMixRate), 0.25, 0.01);
  EXPECT_NEAR(amplitudeAt(220.5, audiblePart(right), kMixRate), 0.125, 0.01);
}

TEST(Mixer, SoundsAreAddedAndClipped) {
  Mixer mixer;
  ASSERT_TRUE(mixer.play({.id = 1, .file = "a"}, toneSource(441, 0.1, 22050, 0.9)));
  ASSERT_TRUE(mixer.play({.id = 2, .file = "b"}, toneSource(441, 0.1, 22050, 0.9)));
  const auto left = sidesOf(mixer, 0.05)[0];
  EXPECT_NEAR(*std::ranges::max_element(left), 32767 / 32768.0, 1e-9);
  EXPECT_NEAR(*std::ranges::min_element(left), -32767 / 32768.0, 1e-9) << "no wrap-around";
  mixer.stop({"a"});
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(1));
  EXPECT_NEAR(amplitudeAt(441, sidesOf(mixer, 0.02)[0], kMixRate), 0.9, 0.02);
}

TEST(Mixer, APlayingFileContinuesWithItsNewParametersAndId) {
  Mixer mixer;
  ASSERT_TRUE(mixer.play({.id = 1, .file = "a", .loop = true}, toneSource(441, 0.1)));
  EXPECT_NEAR(rms(sidesOf(mixer, 0.4)[0]), 0.5 / std::sqrt(2), 0.01) << "a loop without gaps";
  EXPECT_FALSE(mixer.change({.id = 2, .file = "b"}));
  EXPECT_TRUE(mixer.change({.id = 2, .file = "a", .volume = 0.1}));
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(1));
  EXPECT_NEAR(rms(sidesOf(mixer, 0.02)[0]), 0.05 / std::sqrt(2), 0.005);
  EXPECT_THAT(sidesOf(mixer, 0.2)[0].back(), 0) << "the loop has ended";
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(2));
}

TEST(Mixer, ARestartedSoundReplacesThePreviousRestartedOne) {
  Mixer mixer;
  ASSERT_TRUE(mixer.play({.id = 1, .file = "a", .loop = true}, toneSource()));
  ASSERT_TRUE(mixer.play({.id = 2, .file = "b", .loop = true, .afresh = true}, toneSource()));
  EXPECT_FALSE(mixer.change({.id = 3, .file = "a", .afresh = true})) << "not even if it is already playing";
  ASSERT_TRUE(mixer.play({.id = 3, .file = "b", .loop = true, .afresh = true}, toneSource()));
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(2));
  mixer.stop({});
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(1, 3));
}

TEST(Mixer, NewSpeechReplacesSpeechButNotSounds) {
  Mixer mixer;
  ASSERT_TRUE(mixer.play({.id = 1, .file = "a", .loop = true}, toneSource()));
  mixer.speak({.id = 2}, toneSource(441, 1));
  mixer.speak({.id = 3, .volume = 0}, toneSource(441, 1));
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(2));
  EXPECT_NEAR(amplitudeAt(441, sidesOf(mixer, 0.05)[0], kMixRate), 0.5, 0.05) << "volume 0 is silent";
}

TEST(Mixer, SpeechThatIsNotReadyLeavesAGap) {
  Mixer mixer;
  auto voice = toneSource(441, 0.1);
  ToneSource& words = *voice;
  words.waits = true;
  mixer.speak({.id = 1}, std::move(voice));
  EXPECT_EQ(rms(sidesOf(mixer, 0.1)[0]), 0);
  EXPECT_THAT(mixer.takeEnded(), IsEmpty());
  words.waits = false;
  EXPECT_NEAR(rms(sidesOf(mixer, 0.05)[0]), 0.5 / std::sqrt(2), 0.02);
}

TEST(Mixer, AnEmptyLoopEndsAndTooManySoundsAreRejected) {
  Mixer mixer;
  ASSERT_TRUE(mixer.play({.id = 1, .file = "a", .loop = true}, toneSource(441, 0)));
  EXPECT_EQ(rms(sidesOf(mixer, 0.01)[0]), 0);
  EXPECT_THAT(mixer.takeEnded(), ElementsAre(1));
  for (SoundId id = 0; id < kMostSounds; ++id) ASSERT_TRUE(mixer.play({.id = id, .file = "a"}, toneSource()));
  EXPECT_FALSE(mixer.play({.id = 99, .file = "a"}, toneSource()));
}

}  // namespace
}  // namespace darwinop::audio
