// Ends during a walk: the step is finished before the session ends, so that the robot kneels from both feet.
#include <gmock/gmock.h>

#include "gait_rig.hpp"

namespace darwinop::webots_api {
namespace {

using std::chrono::milliseconds;

class EndOfWalk : public GaitManager {
 protected:
  void walkInto(int step) {
    standing().setXAmplitude(1);
    manager().start();
    steps(60 + step);
    ASSERT_NE(goals(), gait::kStanding.tick);
  }
  /// The bound of docs/gait.md: 1.5 periods and what limited goals need, then 0.4 s of standing.
  static constexpr milliseconds kBound{2 * 600 + 600 + 400};
};

TEST_F(EndOfWalk, AfterCtrlCTheLastStepReturnsInTheStance) {
  for (int moment = 0; moment < 38; moment += 3) {  // one period
    stop = false;
    manager_.reset();
    end();
    fake.end_of_session = false;
    walkInto(moment);
    const Nanos before = fake.now;
    stop = true;
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_EQ(goals(), gait::kStanding.tick) << moment;
    EXPECT_LE(fake.now - before, kBound) << moment;
    EXPECT_FALSE(fake.end_of_session);
    const std::size_t published = fake.published.size();
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1) << "at once";
    EXPECT_EQ(fake.published.size(), published);
  }
}

TEST_F(EndOfWalk, CtrlCDuringAStepReturnsFromItInTheStance) {
  for (int moment = 0; moment < 38; moment += 3) {
    stop = false;
    manager_.reset();
    end();
    walkInto(moment);
    fake.during_wait = [this] { stop = true; };
    manager().step(16);
    EXPECT_EQ(robot().step(16), -1);
    EXPECT_EQ(goals(), gait::kStanding.tick) << moment;
  }
}

TEST_F(EndOfWalk, CtrlCDuringALongStepDoesNotWaitForItsEnd) {
  walkInto(7);
  const Nanos before = fake.now;
  fake.during_wait = [this] { stop = true; };
  EXPECT_EQ(robot().step(5000), -1);
  EXPECT_EQ(goals(), gait::kStanding.tick);
  EXPECT_LE(fake.now - before, kBound);
}

/// The last step swings on when the last goal is reached.
TEST_F(EndOfWalk, TheRobotStandsBeforeItKneels) {
  walkInto(7);
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  constexpr std::size_t kStood = 400 / 16;
  ASSERT_GT(fake.published.size(), kStood);
  const Commands& first = fake.published[fake.published.size() - kStood];
  for (std::size_t i = 0; i < kWalking; ++i)
    EXPECT_EQ(ticksFromRad(first.joint[i].goal), gait::kStanding.tick[i]) << kJointTable[i].name;
}

TEST_F(EndOfWalk, ALongPeriodIsNotWaitedForAndNothingMovesAfterwards) {
  write("[Walking Config]\nperiod_time = 3000\n");
  walkInto(44);  // shortly after the right foot came down: the second time from here is too late
  Nanos before = fake.now;
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_NE(goals(), gait::kStanding.tick);
  EXPECT_LT(fake.now - before, milliseconds{3000}) << "the supervisor kills after 3 s";
  before = fake.now;
  EXPECT_EQ(robot().step(16), -1);
  manager_.reset();
  EXPECT_EQ(fake.now, before);
}

TEST_F(EndOfWalk, AControllerThatReturnsFromMainEndsInTheStance) {
  walkInto(7);
  end();  // ~Robot, as exit() and an uncaught exception
  EXPECT_EQ(goals(), gait::kStanding.tick);
  EXPECT_TRUE(fake.end_of_session);
}

TEST_F(EndOfWalk, AManagerDestroyedBeforeItsRobotEndsInTheStance) {
  walkInto(7);
  manager_.reset();
  EXPECT_EQ(goals(), gait::kStanding.tick);
  EXPECT_EQ(robot().step(16), 0);
}

TEST_F(EndOfWalk, AtTheEndOfTheRuntimeTheLastStepReturnsInTheStance) {
  walkInto(7);
  fake.ending = true;
  testing::internal::CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(goals(), gait::kStanding.tick);
}

TEST_F(EndOfWalk, ALoopThatHasGoneIsNotWaitedFor) {
  walkInto(7);
  fake.gone = true;
  const Nanos before = fake.now;
  const std::size_t published = fake.published.size();
  testing::internal::CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  end();
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(fake.now, before);
  EXPECT_LE(fake.published.size(), published + 2) << "by the step, and by one attempt to carry on";
}

TEST_F(EndOfWalk, SafetyIsNotInterfered) {
  walkInto(7);
  fake.image.safety.state = State::kKneeling;
  const Nanos before = fake.now;
  end();
  EXPECT_EQ(fake.now, before);
}

TEST_F(EndOfWalk, OnTheWayToTheStanceItEndsAtOnce) {
  manager().start();
  steps(20);
  const Nanos before = fake.now;
  stop = true;
  EXPECT_EQ(robot().step(16), -1);
  EXPECT_LE(fake.now - before, milliseconds{16}) << "both feet are down";
}

}  // namespace
}  // namespace darwinop::webots_api
