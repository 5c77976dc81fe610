// Walks and motion pages while the robot does not follow: safety does not execute the goals, or the board is silent.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gait_rig.hpp"
#include "managers/messages.hpp"
#include "motion_rig.hpp"

namespace darwinop::webots_api {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int kShort = 15, kLong = 60;  // steps of 16 ms: within the 0.3 s that a motion waits, and beyond

class UnfollowedWalk : public GaitManager {
 protected:
  static constexpr double kApproach = 0.75 * 0.016;  // rad in a step, at most

  void walk(int count) {
    standing().setXAmplitude(1);
    manager().start();
    steps(count);
  }
  /// The robot does not follow. Its joints are somewhere else afterwards: somebody has lifted it.
  void loseFor(int count, State state = State::kOffline) {
    fake.image.safety.state = state;
    steps(count);
    for (JointSensors& joint : fake.image.joint) joint.position = joint.commanded = Rad{joint.position.value + 0.2};
    fake.image.safety.state = State::kDriven;
    robot().step(16);  // this image reaches the controller
  }
  /// Greatest distance of a goal from the robot's pose, rad.
  double farthest() {
    double most = 0;
    for (std::size_t i = 0; i < kWalking; ++i)
      most = std::max(most, std::abs(fake.last().joint[i].goal.value - fake.image.joint[i].position.value));
    return most;
  }
};

TEST_F(UnfollowedWalk, StartsAgainFromTheRobotsPoseAtTheSpeedOfAnApproach) {
  walk(40);
  loseFor(kLong);
  steps(1);
  EXPECT_LE(farthest(), kApproach);
  auto before = fake.last();
  for (int step = 0; step < 15; ++step) {
    steps(1);
    for (std::size_t i = 0; i < kWalking; ++i)
      ASSERT_LE(std::abs(fake.last().joint[i].goal.value - before.joint[i].goal.value), kApproach + 1e-3) << step;
    before = fake.last();
  }
  steps(200);
  const auto stance = goals();
  steps(10);
  EXPECT_NE(goals(), stance) << "it walks";
}

TEST_F(UnfollowedWalk, KeepsItsGoalsMeanwhile) {
  walk(40);
  fake.image.safety.state = State::kOffline;
  robot().step(16);
  const auto there = goals();
  steps(kLong);
  EXPECT_EQ(goals(), there);
  EXPECT_FALSE(fake.last().joint[0].has(JointCommand::kSpeedLimit) &&
               fake.last().joint[0].speed_limit.value == kMaxVelocity)
      << "the joints are the controller's again";
}

TEST_F(UnfollowedWalk, GoesOnAfterAShortInterruption) {
  walk(40);
  fake.image.safety.state = State::kHolding;
  robot().step(16);
  const auto there = goals();
  steps(kShort);
  EXPECT_EQ(goals(), there);
  fake.image.safety.state = State::kDriven;
  steps(1);  // the image is a step old
  steps(40);
  EXPECT_NE(goals(), gait::kStanding.tick);
  EXPECT_GT(fake.last().joint[0].speed_limit.value, 5) << "not an approach";
}

TEST_F(UnfollowedWalk, IsReportedOnce) {
  walk(40);
  testing::internal::CaptureStderr();
  loseFor(kLong);
  steps(40);
  loseFor(kLong);
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr(managers::messages::kNotFollowed));
  EXPECT_EQ(lines(said), 1) << said;
}

TEST_F(UnfollowedWalk, DoesNotStartBeforeTheRobotFollows) {
  standing();
  fake.image.safety.state = State::kOffline;
  robot().step(16);
  manager().start();
  steps(kLong);
  expectUntouched();
  fake.image.safety.state = State::kDriven;
  steps(2);
  EXPECT_TRUE(fake.last().joint[0].has(JointCommand::kGoal));
}

TEST_F(UnfollowedWalk, StopReturnsSoon) {
  walk(40);
  fake.image.safety.state = State::kOffline;
  robot().step(16);
  const Nanos begun = fake.now;
  manager().stop();
  EXPECT_LT(fake.now - begun, std::chrono::milliseconds{400});
  fake.image.safety.state = State::kDriven;
  const auto there = goals();
  steps(20);
  EXPECT_EQ(goals(), there) << "no walk is requested";
}

TEST_F(UnfollowedWalk, StopFinishesTheStepAfterAShortInterruption) {
  walk(40);
  fake.image.safety.state = State::kHolding;
  robot().step(16);
  const Nanos begun = fake.now;
  fake.on_cycle = [&](std::uint64_t) {
    if (fake.now - begun > std::chrono::milliseconds{200}) fake.image.safety.state = State::kDriven;
  };
  manager().stop();
  EXPECT_EQ(goals(), gait::kStanding.tick);
}

class UnfollowedPage : public MotionManagerTest {
 protected:
  UnfollowedPage() {
    pages_[1].step[0].time = 100;  // 0.8 s
    write();
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) robot().step(16);
  }
};

TEST_F(UnfollowedPage, EndsWhereTheRobotLeftIt) {
  managers::DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  steps(20);
  fake.image.safety.state = State::kOffline;
  steps(1);
  const int there = ticksOf(Joint::kNeck);
  testing::internal::CaptureStderr();
  steps(kShort);
  EXPECT_TRUE(manager.isMotionPlaying());
  steps(kLong);
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_EQ(ticksOf(Joint::kNeck), there);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(managers::messages::kNotFollowed));
  fake.image.safety.state = State::kDriven;
  steps(kLong);
  EXPECT_EQ(ticksOf(Joint::kNeck), there);
}

TEST_F(UnfollowedPage, GoesOnAfterAShortInterruption) {
  managers::DARwInOPMotionManager manager{&robot(), path_};
  manager.playPage(1, false);
  steps(20);
  fake.image.safety.state = State::kHolding;
  steps(kShort);
  fake.image.safety.state = State::kDriven;
  steps(60 - 20);
  EXPECT_FALSE(manager.isMotionPlaying());
  EXPECT_EQ(ticksOf(Joint::kNeck), 2100);
}

TEST_F(UnfollowedPage, ThatIsWaitedForReturns) {
  managers::DARwInOPMotionManager manager{&robot(), path_};
  fake.image.safety.state = State::kOffline;
  robot().step(16);
  const Nanos begun = fake.now;
  manager.playPage(1);
  EXPECT_LT(fake.now - begun, std::chrono::milliseconds{400});
  EXPECT_FALSE(manager.isMotionPlaying());
}

}  // namespace
}  // namespace darwinop::webots_api
