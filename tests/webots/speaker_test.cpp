// The loudspeaker as controllers use it: orders, events, steps, and an output that fails.
#include <gmock/gmock.h>

#include <deque>
#include <webots/Speaker.hpp>

#include "fixture.hpp"

namespace darwinop::webots_api {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

struct Loudspeaker {
  std::vector<SoundOrder> orders;
  std::deque<SoundEvent> events;
  std::function<std::deque<SoundEvent>(const SoundOrder&)> answer;
  bool full = false;
};

class FakeOutput : public SoundOutput {
 public:
  explicit FakeOutput(Loudspeaker& loudspeaker) : loudspeaker_{loudspeaker} {}
  bool order(const SoundOrder& order) override {
    if (loudspeaker_.full) return false;
    loudspeaker_.orders.push_back(order);
    if (loudspeaker_.answer) loudspeaker_.events = loudspeaker_.answer(order);
    return true;
  }
  std::optional<SoundEvent> nextEvent(std::chrono::milliseconds) override {
    if (loudspeaker_.events.empty()) return std::nullopt;
    SoundEvent first = loudspeaker_.events.front();
    loudspeaker_.events.pop_front();
    return first;
  }

 private:
  Loudspeaker& loudspeaker_;
};

class SpeakerTest : public Facade {
 protected:
  webots::Speaker& speaker() { return *robot().getSpeaker("Speaker"); }
  void prepare() {
    robot();
    currentRobot()->open_sound = [this]() -> std::unique_ptr<SoundOutput> {
      if (!why_no_sound.empty()) throw std::runtime_error(why_no_sound);
      ++opened;
      return std::make_unique<FakeOutput>(loudspeaker);
    };
    testing::internal::CaptureStderr();
    captures_ = true;
  }
  ~SpeakerTest() override {
    if (captures_) printed();
  }
  /// All that was printed since prepare(); once.
  std::string printed() {
    captures_ = false;
    return testing::internal::GetCapturedStderr();
  }
  template <class Order>
  Order last() {
    return std::get<Order>(loudspeaker.orders.back());
  }

  Loudspeaker loudspeaker;
  std::string why_no_sound;
  int opened = 0;

 private:
  bool captures_ = false;
};

TEST_F(SpeakerTest, BothStylesOfSpeechBecomeOrders) {
  prepare();
  EXPECT_EQ(opened, 0) << "nobody spoke";
  speaker().speak("hello", "de", 120);
  EXPECT_EQ(last<Speak>(), (Speak{.id = 1, .text = "hello", .voice = "de", .words_per_minute = 120}));
  speaker().speak("hello");
  EXPECT_EQ(last<Speak>(), (Speak{.id = 2, .text = "hello"}));
  EXPECT_TRUE(speaker().setLanguage("fr-FR"));
  speaker().speak("salut", 0.5);
  EXPECT_EQ(last<Speak>(), (Speak{.id = 3, .text = "salut", .voice = "fr-FR", .volume = 0.5}));
  speaker().speakFile("/x/text.txt", "it", 80);
  EXPECT_EQ(last<Speak>(),
            (Speak{.id = 4, .text = "/x/text.txt", .text_is_file = true, .voice = "it", .words_per_minute = 80}));
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(printed(), "");
}

TEST_F(SpeakerTest, ItSpeaksUntilTheEventThatItsLastWordsHaveEnded) {
  prepare();
  EXPECT_FALSE(speaker().isSpeaking());
  speaker().speak("one", 1);
  speaker().speak("two", 1);
  loudspeaker.events = {SoundEnded{1}};
  EXPECT_TRUE(speaker().isSpeaking()) << "that was the first text";
  loudspeaker.events = {SoundEnded{2}};
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_TRUE(loudspeaker.events.empty()) << "a step takes the events";
  EXPECT_FALSE(speaker().isSpeaking());
  EXPECT_EQ(printed(), "");
}

TEST_F(SpeakerTest, SoundsAreKnownByTheirFilesAndStopAtOnce) {
  prepare();
  webots::Speaker& s = speaker();
  webots::Speaker::playSound(&s, &s, "/a.wav", 0.5, 2, -0.5, true);
  EXPECT_EQ(last<PlaySound>(),
            (PlaySound{.id = 1, .file = "/a.wav", .volume = 0.5, .pitch = 2, .balance = -0.5, .loop = true}));
  webots::Speaker::playSound(nullptr, &s, "/b.wav", 1, 1, -1, false);
  EXPECT_EQ(last<PlaySound>().balance, 0) << "one loudspeaker alone has no sides";
  EXPECT_TRUE(s.isSoundPlaying("/a.wav") && s.isSoundPlaying("/b.wav") && s.isSoundPlaying(""));
  EXPECT_FALSE(s.isSoundPlaying("/c.wav"));
  s.stop("/a.wav");
  EXPECT_EQ(last<StopSound>().file, "/a.wav");
  EXPECT_FALSE(s.isSoundPlaying("/a.wav"));
  s.speak("hello", 1);
  s.stop("");
  EXPECT_FALSE(s.isSpeaking() || s.isSoundPlaying(""));
  EXPECT_EQ(printed(), "");
}

TEST_F(SpeakerTest, ValuesBeyondTheirRangesAreBroughtThereAndAreReportedOnce) {
  prepare();
  webots::Speaker& s = speaker();
  for (int i = 0; i < 2; ++i) webots::Speaker::playSound(&s, &s, "/a.wav", 3, 0.1, std::nan(""), false);
  EXPECT_EQ(last<PlaySound>(), (PlaySound{.id = 2, .file = "/a.wav", .volume = 1, .pitch = 0.5, .balance = 0}));
  s.speak("x", "en", 1000);
  EXPECT_EQ(last<Speak>().words_per_minute, 450);
  s.speak(std::string(31'999, 'x') + "\u00fc", 1);
  EXPECT_EQ(last<Speak>().text.size(), 31'999U) << "a letter is not cut in two";
  const std::string text = printed();
  EXPECT_EQ(std::ranges::count(text, '\n'), 5) << "volume, pitch, balance, speed, length";
  EXPECT_THAT(text, HasSubstr("a speed lies between 80 and 450; it"));
}

TEST_F(SpeakerTest, PlayFileWaitStepsTheRobotUntilTheSoundHasEnded) {
  prepare();
  loudspeaker.answer = [](const SoundOrder&) { return std::deque<SoundEvent>{SoundStarted{1, 0.08}}; };
  const auto before = fake.published.size();
  fake.on_cycle = [&](std::uint64_t) {
    if (fake.published.size() == before + 20) loudspeaker.events = {SoundEnded{1}};
  };
  speaker().playFileWait("/a.mp3");
  EXPECT_EQ(fake.published.size(), before + 20) << "its 0.08 s do not matter here, its end does";
  EXPECT_TRUE(last<PlaySound>().afresh);
}

/// A class that walks in its step() goes on walking meanwhile.
TEST_F(SpeakerTest, PlayFileWaitCallsTheControllersOwnStep) {
  struct Walker : webots::Robot {
    explicit Walker(RobotImpl* impl) : Robot(impl) {}
    int step(int ms) override {
      ++steps;
      return Robot::step(ms);
    }
    int steps = 0;
  } walker{makeImpl()};
  currentRobot()->open_sound = [this] { return std::make_unique<FakeOutput>(loudspeaker); };
  loudspeaker.answer = [](const SoundOrder&) { return std::deque<SoundEvent>{SoundStarted{1, 0.08}}; };
  fake.on_cycle = [&](std::uint64_t) {
    if (walker.steps == 5) loudspeaker.events = {SoundEnded{1}};
  };
  walker.getSpeaker("Speaker")->playFileWait("/a.mp3");
  EXPECT_EQ(walker.steps, 5);
}

TEST_F(SpeakerTest, InSimulatedTimePlayFileWaitTakesTheTimeOfTheSound) {
  fake.real_time = false;
  prepare();
  loudspeaker.answer = [](const SoundOrder&) { return std::deque<SoundEvent>{SoundStarted{1, 0.08}}; };
  const double begin = robot().getTime();
  speaker().playFileWait("/a.mp3");
  EXPECT_NEAR(robot().getTime() - begin, 0.08, 0.001);
}

TEST_F(SpeakerTest, ASimulationThatIsSlowerThanTheSoundTakesAsManySteps) {
  fake.real_time = false;
  prepare();
  loudspeaker.answer = [](const SoundOrder&) { return std::deque<SoundEvent>{SoundStarted{1, 0.08}}; };
  const auto before = fake.published.size();
  fake.on_cycle = [&](std::uint64_t) {
    if (fake.published.size() == before + 1) loudspeaker.events = {SoundEnded{1}};
  };
  const double begin = robot().getTime();
  speaker().playFileWait("/a.mp3");
  EXPECT_NEAR(robot().getTime() - begin, 0.08, 0.001);
}

TEST_F(SpeakerTest, PlayFileWaitEndsWithTheControllerAndWhenNothingIsPlayed) {
  prepare();
  loudspeaker.answer = [](const SoundOrder&) {
    return std::deque<SoundEvent>{SoundError{"broken file"}, SoundEnded{1}};
  };
  speaker().playFileWait("/a.mp3");
  loudspeaker.answer = nullptr;
  speaker().playFileWait("/b.mp3");
  EXPECT_GT(robot().getTime(), 10) << "a program that hangs is not waited for for ever";
  stop = true;
  speaker().playFileWait("/c.mp3");
  EXPECT_THAT(printed(), HasSubstr("Speaker: broken file\n"));
}

TEST_F(SpeakerTest, WithoutAProgramOneSentenceIsPrintedAndNothingSounds) {
  prepare();
  why_no_sound = "broken program";
  webots::Speaker& s = speaker();
  s.speak("hello", "en", 120);
  s.playFile("x.wav");
  s.playFileWait("x.wav");
  s.stop("");
  webots::Speaker::playSound(&s, &s, "x.wav", 1, 1, 0, false);
  EXPECT_FALSE(s.isSpeaking() || s.isSoundPlaying(""));
  EXPECT_EQ(printed(), "darwinop: Speaker: sounds and speech are skipped: broken program\n");
}

TEST_F(SpeakerTest, AProgramThatDiedIsReportedAndTheNextSoundStartsAnotherOne) {
  prepare();
  speaker().speak("hello", 1);
  speaker().playFile("/a.mp3");
  loudspeaker.events = {SoundLost{"it was ended by signal 9"}};
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_FALSE(speaker().isSpeaking() || speaker().isSoundPlaying(""));
  speaker().playFile("/a.mp3");
  EXPECT_EQ(opened, 2);
  loudspeaker.events = {SoundLost{"it was ended by signal 9"}};
  speaker().stop("");
  EXPECT_EQ(opened, 2) << "no program is started to be silent";
  speaker().playFile("/a.mp3");
  EXPECT_TRUE(speaker().isSoundPlaying("/a.mp3"));
  loudspeaker.full = true;
  speaker().playFile("/b.mp3");
  EXPECT_FALSE(speaker().isSoundPlaying("/b.mp3"));
  EXPECT_THAT(printed(), HasSubstr("ended by signal 9\ndarwinop: Speaker: too many orders"));
}

}  // namespace
}  // namespace darwinop::webots_api
