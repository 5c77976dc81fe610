// What comes out of the card: tones, speech, both, at their times and levels.
#include <gmock/gmock.h>

#include <thread>

#include "apps/sound/graph.hpp"

namespace darwinop {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

double secondsOfSound(const std::vector<double>& values, int rate) {
  return static_cast<double>(audiblePart(values).size()) / rate;
}

/// Parts of the energy around 250, 500, 1000, 2000 Hz, and the largest part that one single frequency has.
struct Spectrum {
  std::vector<double> octave = std::vector<double>(4);
  double peak = 0;
};
Spectrum spectrumOf(const std::vector<double>& values, int rate) {
  Spectrum spectrum;
  double all = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double low = 180 * std::pow(2, i);
    for (double hertz = low; hertz < 2 * low; hertz += low / 24) {
      const double power = std::pow(amplitudeAt(hertz, values, rate), 2);
      spectrum.octave[i] += power;
      spectrum.peak = std::max(spectrum.peak, power);
      all += power;
    }
  }
  for (double& part : spectrum.octave) part /= all;
  spectrum.peak /= all;
  return spectrum;
}

/// A voice fills several octaves and has no single pitch; a tone does neither.
void expectSpeech(const std::vector<double>& values, int rate) {
  const Spectrum spectrum = spectrumOf(values, rate);
  for (const double part : spectrum.octave) EXPECT_GT(part, 0.005);
  EXPECT_LT(spectrum.peak, 0.4);
  // Syllables: it is loud and quiet by turns.
  std::vector<double> levels;
  const auto window = static_cast<std::size_t>(rate / 25);
  for (std::size_t i = 0; i + window < values.size(); i += window)
    levels.push_back(rms(std::span{values}.subspan(i, window)));
  std::ranges::sort(levels);
  ASSERT_GT(levels.size(), 10U);
  EXPECT_GT(levels[levels.size() * 9 / 10], 4 * levels[levels.size() / 10]);
}

TEST_F(SoundGraph, AToneSoundsForItsTimeAtItsPitchAndVolume) {
  sound().order(PlaySound{.id = 1, .file = toneFile(440, 0.4), .volume = 0.5, .balance = 0.5});
  awaitEnd(1);
  EXPECT_DOUBLE_EQ(seconds, 0.4);
  const Wave wave = recorded();
  ASSERT_EQ(wave.channels, 2);
  const auto left = audiblePart(wave.channel(0)), right = audiblePart(wave.channel(1));
  EXPECT_NEAR(secondsOfSound(right, wave.rate), 0.4, 0.01);
  EXPECT_NEAR(amplitudeAt(440, right, wave.rate), 0.25, 0.01);
  EXPECT_NEAR(amplitudeAt(440, left, wave.rate), 0.125, 0.01);
  EXPECT_LT(amplitudeAt(880, right, wave.rate), 0.01);
  EXPECT_EQ(said, "");
}

TEST_F(SoundGraph, AnMp3FileAnOctaveHigherTakesHalfItsTime) {
  sound().order(PlaySound{.id = 1, .file = DARWINOP_MP3, .pitch = 2});
  awaitEnd(1);
  const Wave wave = recorded();
  const auto values = audiblePart(wave.channel(0));
  EXPECT_NEAR(secondsOfSound(values, wave.rate), 0.25, 0.06) << "an MP3 file begins and ends with some silence";
  EXPECT_GT(amplitudeAt(1760, values, wave.rate), 10 * amplitudeAt(880, values, wave.rate));
}

TEST_F(SoundGraph, SpeechIsSpeechAndASoundCanBeMixedIntoIt) {
  const std::string text = "The robot walks over the green field and looks for its ball.";
  sound().order(Speak{.id = 1, .text = text, .words_per_minute = 250});
  awaitBegin(1);
  std::this_thread::sleep_for(400ms);
  sound().order(PlaySound{.id = 2, .file = toneFile(5000, 0.5)});  // above what the voice has
  awaitEnd(1);
  EXPECT_EQ(said, "");
  const Wave wave = recorded();
  const auto values = audiblePart(wave.channel(0));
  EXPECT_GT(secondsOfSound(values, wave.rate), 1.5);
  expectSpeech(values, wave.rate);
  EXPECT_GT(amplitudeAt(5000, values, wave.rate), 0.02);
}

TEST_F(SoundGraph, ATextIsNeverACommandNorMarksOfSsml) {
  const std::string trap = folder / "trap";
  const std::string text = "\"; touch " + trap + "; $(touch " + trap + ") `touch " + trap + "` | touch " + trap +
                           " <audio src='" + trap + "'/> [[h@loU]] -w " + trap + " --stdout \xff\xfe";
  sound().order(Speak{.id = 1, .text = text, .voice = "en;touch " + trap, .words_per_minute = 450});
  awaitBegin(1);
  std::this_thread::sleep_for(200ms);
  sound().order(StopSound{});
  awaitEnd(1);
  EXPECT_GT(rms(audiblePart(recorded().channel(0))), 0.01);
  EXPECT_FALSE(std::filesystem::exists(trap));
  EXPECT_THAT(said, HasSubstr("voice \"en;touch"));
}

TEST_F(SoundGraph, ALoopGoesOnUntilItIsStopped) {
  const std::string file = toneFile(440, 0.1);
  sound().order(PlaySound{.id = 1, .file = file, .loop = true});
  awaitBegin(1);
  std::this_thread::sleep_for(500ms);
  sound().order(PlaySound{.id = 2, .file = file, .volume = 0.1, .loop = true});
  awaitEnd(1);  // it goes on under its new name
  std::this_thread::sleep_for(300ms);
  sound().order(StopSound{file});
  awaitEnd(2);
  const Wave wave = recorded();
  const auto values = audiblePart(wave.channel(0));
  EXPECT_GT(secondsOfSound(values, wave.rate), 0.8);
  const std::span all{values};
  const auto quarter = all.size() / 4;
  EXPECT_NEAR(amplitudeAt(440, all.first(quarter), wave.rate), 0.5, 0.05);
  EXPECT_NEAR(amplitudeAt(440, all.last(quarter / 4), wave.rate), 0.05, 0.01);
}

}  // namespace
}  // namespace darwinop
