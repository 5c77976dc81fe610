// Gait manager: invalid files, copies, joints taken by other managers, destroyed robots, exceptions.
#include <gmock/gmock.h>

#include <RobotisOp2GaitManager.hpp>
#include <cmath>
#include <stdexcept>
#include <webots/Motor.hpp>

#include "gait_rig.hpp"
#include "managers/messages.hpp"

namespace darwinop::webots_api {
namespace {

using managers::DARwInOPGaitManager;
using testing::HasSubstr;

using GaitLending = GaitManager;

TEST_F(GaitLending, AnInvalidFileDisablesItWithAMessage) {
  write("[Walking Config]\nperiod_time = 10\n");
  testing::internal::CaptureStderr();
  EXPECT_FALSE(manager().isCorrectlyInitialized());
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("config.ini, line 2: period_time = 10: give a number"));
  manager().start();
  steps(20);
  expectUntouched();
  manager().stop();
}

TEST_F(GaitLending, WalksWithoutAFileAndWarnsOnce) {
  testing::internal::CaptureStderr();
  managers::RobotisOp2GaitManager one{&robot(), "/nowhere/config.ini"}, other{&robot(), "/nowhere/config.ini"};
  EXPECT_TRUE(one.isCorrectlyInitialized() && other.isCorrectlyInitialized());
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, HasSubstr("cannot find /nowhere/config.ini: the default gait parameters are used"));
  EXPECT_EQ(lines(said), 1);
}

TEST_F(GaitLending, ReportsANullRobot) {
  testing::internal::CaptureStderr();
  DARwInOPGaitManager nobody{nullptr, ini()};
  nobody.start();
  nobody.step(16);
  nobody.stop();
  EXPECT_FALSE(nobody.isCorrectlyInitialized());
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr(managers::messages::kRobotIsNull));
}

TEST_F(GaitLending, CopiesStartAtRest) {
  standing().start();
  steps(5);
  DARwInOPGaitManager copy = manager();
  DARwInOPGaitManager assigned{&robot(), ini()};
  assigned = copy;
  const auto there = goals();
  for (int i = 0; i < 5; ++i) {
    copy.step(16);
    assigned.step(16);
    robot().step(16);
  }
  EXPECT_EQ(goals(), there);
}

TEST_F(GaitLending, RestoresGainsAndLimitsIfDestroyedDuringAStep) {
  webots::Motor& knee = *robot().getMotor("LegLowerR");
  knee.setVelocity(2);
  knee.setControlPID(6, 0, 0);
  standing().start();
  steps(5);
  EXPECT_NE(fake.last().joint[index(Joint::kLegLowerR)].p_gain, 6);
  manager_.reset();
  robot().step(16);
  EXPECT_EQ(fake.last().joint[index(Joint::kLegLowerR)].p_gain, 6);
  EXPECT_EQ(knee.getVelocity(), 2);
}

TEST_F(GaitLending, ASpeedThatIsSetDuringAWalkCountsAfterIt) {
  webots::Motor& arm = *robot().getMotor("ArmUpperL");
  standing().start();
  steps(5);
  arm.setVelocity(1);
  arm.setAcceleration(2);
  steps(1);
  const JointCommand& command = fake.last().joint[index(Joint::kArmUpperL)];
  EXPECT_GT(command.speed_limit.value, 12) << "it would make the robot fall";
  manager().stop();
  EXPECT_EQ(arm.getVelocity(), 1);
  arm.setPosition(2);
  robot().step(16);
  EXPECT_NEAR(fake.last().joint[index(Joint::kArmUpperL)].speed_limit.value, 0.032, 1e-9) << "from rest";
}

TEST_F(GaitLending, AManagerThatStopsLeavesItsSuccessorFullSpeed) {
  robot().getMotor("LegLowerR")->setVelocity(2);
  standing().start();
  steps(5);
  DARwInOPGaitManager next{&robot(), ini()};
  next.setBalanceEnable(false);
  next.start();
  const auto knee_speed = [&] {
    next.step(16);
    robot().step(16);
    return fake.last().joint[index(Joint::kLegLowerR)].speed_limit.value;
  };
  currentRobot()->joints_taken_by = nullptr;  // a page that interrupted the first walk has ended
  ASSERT_GT(knee_speed(), 12);
  manager().stop();
  EXPECT_GT(knee_speed(), 12) << "a speed limit would make the robot fall";
}

TEST_F(GaitLending, AJointThatWasGivenNoSpeedGetsTheRobotsUsualOneBack) {
  fake.image.safety.default_speed = 3;
  standing().start();
  steps(5);
  manager_.reset();
  robot().step(16);
  EXPECT_EQ(fake.last().joint[index(Joint::kLegLowerR)].speed_limit.value, 3);
}

TEST_F(GaitLending, AWalkByStepsShorterThanATickApproachesSmoothly) {
  manager().setBalanceEnable(false);  // the robot sits
  manager().start();
  robot().step(4);
  EXPECT_THAT(goals(), testing::Each(-1)) << "no tick has run";
  robot().step(4);
  for (std::size_t i = 0; i < kWalking; ++i) EXPECT_NEAR(goals()[i], kJointTable[i].start, 12) << kJointTable[i].name;
}

/// Of the loop, with what robot.ini says, and not of the controller's own file.
TEST_F(GaitLending, AJointThatWasGivenNoGainGetsTheRobotsUsualOneBack) {
  fake.image.safety.default_p_gain = 2;
  standing().start();
  steps(5);
  manager_.reset();
  robot().step(16);
  EXPECT_EQ(fake.last().joint[index(Joint::kLegLowerR)].p_gain, 2);
}

TEST_F(GaitLending, ReleasesJointsTakenByAPageAndRestartsAfterIt) {
  standing().start();
  steps(20);
  const auto mid_step = goals();
  int page = 0;
  currentRobot()->joints_taken_by = &page;
  steps(5);
  EXPECT_EQ(goals(), mid_step);
  for (std::size_t i = 0; i < kWalking; ++i)  // sitting after the page
    fake.image.joint[i].position = fake.image.joint[i].commanded = radFromTicks(kJointTable[i].start);
  for (std::size_t i = 0; i < kWalking; ++i)
    robot().getMotor(std::string{kJointTable[i].name})->setPosition(radFromTicks(kJointTable[i].start).value);
  robot().step(16);
  currentRobot()->joints_taken_by = nullptr;
  steps(1);
  for (std::size_t i = 0; i < kWalking; ++i) EXPECT_NEAR(goals()[i], kJointTable[i].start, 12) << "smoothly from there";
}

TEST_F(GaitLending, AnUnknownJointInVelocityControlGetsFiniteGoals) {
  standing();
  const std::size_t knee = index(Joint::kLegLowerR);
  robot().getMotor("LegLowerR")->setPosition(INFINITY);
  fake.image.joint[knee].position = fake.image.joint[knee].commanded = {};
  robot().step(16);
  manager().start();
  for (int i = 0; i < 20; ++i) {
    steps(1);
    const JointCommand& command = fake.last().joint[knee];
    ASSERT_TRUE(command.has(JointCommand::kGoal));
    ASSERT_TRUE(std::isfinite(command.goal.value));
  }
}

TEST_F(GaitLending, MayOutliveItsRobot) {
  standing().start();
  steps(5);
  end();
  manager().step(16);
  manager().stop();
  manager().start();
  manager().step(16);
}

TEST_F(GaitLending, AnExceptionFromAStepLeavesItUsable) {
  standing().start();
  steps(30);
  fake.on_cycle = [](std::uint64_t) { throw std::runtime_error("the controller's own"); };
  EXPECT_THROW(manager().stop(), std::runtime_error);
  fake.on_cycle = {};
  manager().stop();
  const auto stance = goals();
  steps(5);
  EXPECT_EQ(goals(), stance) << "it rests";
}

}  // namespace
}  // namespace darwinop::webots_api
