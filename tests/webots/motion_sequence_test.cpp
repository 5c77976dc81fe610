// Sequences of .motion files in the style of published controllers: play(), then wait() for the duration.
#include <fstream>
#include <webots/utils/Motion.hpp>

#include "fixture.hpp"
#include "support/temporary_folder.hpp"

namespace darwinop::webots_api {
namespace {

/// The neck is at 0, a slow move of more than a second away from the first pose.
constexpr const char* kWave = "#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,1\n00:00:160,B,1.2\n00:00:320,A,1\n";
constexpr const char* kRise = "#WEBOTS_MOTION,V1.0,Neck\n00:00:000,A,1\n00:00:160,B,1.2\n";

class MotionSequence : public Facade {
 protected:
  MotionSequence() {
    JointSensors& neck = fake.image.joint[index(Joint::kNeck)];
    neck.commanded = neck.position = Rad{0};
    fake.on_cycle = [this](std::uint64_t) {  // the neck follows
      const JointCommand& asked = fake.last().joint[index(Joint::kNeck)];
      JointSensors& joint = fake.image.joint[index(Joint::kNeck)];
      if (asked.has(JointCommand::kGoal)) joint.commanded = joint.position = asked.goal;
    };
    robot();
  }
  std::string file(const std::string& text) {
    std::ofstream{folder_ / "test.motion"} << text;
    return folder_ / "test.motion";
  }
  /// As published.
  void wait(int ms) {
    const double start = robot().getTime(), seconds = ms / 1000.0;
    while (start + seconds >= robot().getTime())
      if (robot().step(16) == -1) return;
  }
  /// Images in which the neck is at the top.
  [[nodiscard]] std::size_t tops() const {
    std::size_t seen = 0;
    for (const Commands& image : fake.published)
      if (image.joint[index(Joint::kNeck)].goal.value == 1.2) ++seen;
    return seen;
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(MotionSequence, TheMoveToTheFirstPoseTakesNoRepetition) {
  webots::Motion wave{file(kWave)};
  for (int repetition = 0; repetition < 3; ++repetition) {
    wave.play();
    wait(wave.getDuration());
  }
  EXPECT_EQ(tops(), 3U);
}

TEST_F(MotionSequence, NorIfTheDurationWasAskedBefore) {
  webots::Motion wave{file(kWave)};
  const int duration_ms = wave.getDuration();
  EXPECT_EQ(duration_ms, 320);
  for (int repetition = 0; repetition < 3; ++repetition) {
    wave.play();
    wait(duration_ms);
  }
  wait(2000);
  EXPECT_EQ(tops(), 3U);
}

TEST_F(MotionSequence, AMotionIsOverAfterItsDuration) {
  webots::Motion rise{file(kRise)};
  rise.play();
  EXPECT_GT(rise.getDuration(), 1000);
  wait(rise.getDuration());
  EXPECT_TRUE(rise.isOver());
  EXPECT_EQ(fake.last().joint[index(Joint::kNeck)].goal.value, 1.2);
  EXPECT_EQ(rise.getDuration(), 160);
}

/// A key that is held for a second.
TEST_F(MotionSequence, AMotionThatIsAskedForInEveryStepIsPlayedOnce) {
  webots::Motion wave{file(kWave)};
  for (int step = 0; step < 60; ++step) {
    wave.play();
    (void)robot().step(16);
  }
  wait(10'000);
  EXPECT_EQ(tops(), 1U);
}

TEST_F(MotionSequence, AStopForgetsTheRepetition) {
  webots::Motion wave{file(kWave)};
  wave.play();
  wait(400);
  wave.play();
  wave.stop();
  wave.play();
  wait(5000);
  EXPECT_EQ(tops(), 1U);
}

}  // namespace
}  // namespace darwinop::webots_api
