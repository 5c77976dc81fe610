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
  testing::internal::CaptureStderr();
  EXPECT_EQ(robot().step(16), -1);
  end();
  testing::internal::GetCapturedStderr();
  EXPECT_EQ(fake.now, before);
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
