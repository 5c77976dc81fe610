// What each call on a motor makes of the command image.
#include <gmock/gmock.h>

#include <cmath>
#include <webots/Motor.hpp>
#include <webots/PositionSensor.hpp>
#include <webots/Servo.hpp>

#include "fixture.hpp"

namespace darwinop::webots_api {
namespace {

using testing::HasSubstr;
using testing::NanSensitiveDoubleEq;
using testing::internal::CaptureStderr;
using testing::internal::GetCapturedStderr;

constexpr Joint kElbow = Joint::kArmLowerR;

class MotorTest : public Facade {
 protected:
  webots::Motor& motor() { return *robot().getMotor("ArmLowerR"); }
  JointSensors& joint() { return fake.image.joint[index(kElbow)]; }
};

TEST_F(MotorTest, AMotorThatWasNotTouchedAsksForNothing) {
  EXPECT_EQ(commanded(kElbow).set, 0);
  motor().setPosition(0.1);
  robot().step(16);
  EXPECT_EQ(fake.last().joint[index(Joint::kArmLowerL)].set, 0);
}

TEST_F(MotorTest, SetPositionIsPassedOnUnclampedForSafetyToJudge) {
  motor().setPosition(2.5);
  const JointCommand command = commanded(kElbow);
  EXPECT_EQ(command.set, JointCommand::kGoal);
  EXPECT_EQ(command.goal.value, 2.5);
}

TEST_F(MotorTest, TargetPositionIsInRadians) {
  EXPECT_DOUBLE_EQ(motor().getTargetPosition(), joint().commanded.value);
  motor().setPosition(0.25);
  EXPECT_EQ(motor().getTargetPosition(), 0.25);
}

TEST_F(MotorTest, SetVelocityIsTheSpeedLimitWithoutItsSign) {
  motor().setVelocity(-2);
  const JointCommand command = commanded(kElbow);
  EXPECT_EQ(command.set, JointCommand::kSpeedLimit);
  EXPECT_EQ(command.speed_limit.value, 2);
  EXPECT_EQ(motor().getVelocity(), -2);
}

TEST_F(MotorTest, AnInfinitePositionIsVelocityControl) {
  motor().setPosition(INFINITY);
  motor().setVelocity(1.5);
  EXPECT_EQ(commanded(kElbow).goal.value, motor().getMaxPosition());
  motor().setVelocity(-1.5);
  const JointCommand back = commanded(kElbow);
  EXPECT_EQ(back.goal.value, motor().getMinPosition());
  EXPECT_EQ(back.speed_limit.value, 1.5);
}

/// So near to the joint that it turns at once, and so far ahead that it has its whole torque.
TEST_F(MotorTest, VelocityAndTorqueControlKeepTheGoalAtTheErrorOfTheWholeTorque) {
  fake.image.safety.default_p_gain = 4;
  joint().position = Rad{0};
  joint().velocity = RadPerSec{0};
  robot().step(16);
  motor().setPosition(INFINITY);
  motor().setVelocity(0.5);
  EXPECT_NEAR(commanded(kElbow).goal.value, 1023 * kRadPerTick / 4, 1e-9);
  joint().velocity = RadPerSec{0.5};
  robot().step(16);
  EXPECT_NEAR(commanded(kElbow).goal.value, 1023 * kRadPerTick / 4 + 0.05, 1e-9);
  motor().setVelocity(-0.5);
  EXPECT_LT(commanded(kElbow).goal.value, 0) << "it turns at once";
  motor().setControlPID(8, 0, 0);
  motor().setPosition(-2);
  EXPECT_EQ(commanded(kElbow).goal.value, -2) << "a controller's goal is never changed";
  motor().setTorque(-0.25);
  EXPECT_NEAR(commanded(kElbow).goal.value, 1023 * kRadPerTick / 80 + 0.05, 1e-9) << "a tenth of the torque";
  joint().position = Rad{};
  robot().step(16);
  EXPECT_EQ(commanded(kElbow).goal.value, motor().getMaxPosition()) << "where the joint is unknown";
}

TEST_F(MotorTest, VelocityControlAtSpeedZeroHoldsTheJointWhereItIs) {
  joint().position = Rad{0.3};
  motor().setPosition(INFINITY);
  motor().setVelocity(0);
  EXPECT_EQ(commanded(kElbow).goal.value, 0.3);
  joint().position = Rad{0.2};  // sagging does not move the point
  commanded(kElbow);
  EXPECT_EQ(commanded(kElbow).goal.value, 0.3);
  motor().setVelocity(1);
  commanded(kElbow);
  motor().setVelocity(0);
  EXPECT_EQ(commanded(kElbow).goal.value, 0.2) << "the next stop holds another point";
}

TEST_F(MotorTest, ZeroTorqueIsLimpUntilAPositiveOne) {
  motor().setAvailableTorque(0);
  JointCommand command = commanded(kElbow);
  EXPECT_EQ(command.set, JointCommand::kTorque);
  EXPECT_FALSE(command.torque_on);
  motor().setPosition(0.1);
  command = commanded(kElbow);
  EXPECT_FALSE(command.torque_on) << "a goal does not bring torque back";
  motor().setAvailableTorque(1.25);
  command = commanded(kElbow);
  EXPECT_TRUE(command.torque_on);
  EXPECT_EQ(command.torque_limit.value, 1.25);
}

TEST_F(MotorTest, AvailableTorqueIsClampedAsIn2013) {
  motor().setAvailableTorque(99);
  EXPECT_EQ(commanded(kElbow).torque_limit.value, 2.5);
  motor().setAvailableTorque(-1);
  EXPECT_FALSE(commanded(kElbow).torque_on);
}

TEST_F(MotorTest, SetTorquePushesAgainstAnEndOfTheRange) {
  motor().setTorque(0.5);
  JointCommand command = commanded(kElbow);
  EXPECT_EQ(command.goal.value, motor().getMinPosition()) << "positive turns clockwise, as in 2013";
  EXPECT_EQ(command.torque_limit.value, 0.5);
  motor().setForce(-0.25);
  command = commanded(kElbow);
  EXPECT_EQ(command.goal.value, motor().getMaxPosition());
  EXPECT_EQ(command.torque_limit.value, 0.25);
}

TEST_F(MotorTest, SetTorqueIsBoundedByTheAvailableTorque) {
  motor().setAvailableTorque(1);
  motor().setTorque(2);
  EXPECT_EQ(commanded(kElbow).torque_limit.value, 1);
}

/// A torque loop over positions in ticks gives 0 now and then; off and on again would take seven cycles.
TEST_F(MotorTest, ATorqueThatPassesZeroSwitchesNothingOff) {
  motor().setTorque(0.3);
  commanded(kElbow);
  motor().setTorque(0);
  const JointCommand zero = commanded(kElbow);
  EXPECT_TRUE(zero.torque_on);
  EXPECT_LT(zero.torque_limit.value, 0.003);
  EXPECT_EQ(zero.goal.value, joint().position.value);
  motor().setTorque(-0.3);
  EXPECT_EQ(commanded(kElbow).torque_limit.value, 0.3);
  for (int step = 0; step < 7; ++step) {
    motor().setTorque(0);
    commanded(kElbow);
  }
  EXPECT_FALSE(commanded(kElbow).torque_on) << "now it is limp";
}

TEST_F(MotorTest, SetTorqueZeroStaysLimpUntilAPositionIsSet) {
  motor().setTorque(0);
  EXPECT_FALSE(commanded(kElbow).torque_on) << "from a position: limp at once";
  EXPECT_FALSE(commanded(kElbow).torque_on);
  motor().setPosition(0.1);
  const JointCommand command = commanded(kElbow);
  EXPECT_TRUE(command.torque_on);
  EXPECT_EQ(command.goal.value, 0.1);
  EXPECT_EQ(command.torque_limit.value, 2.5);
}

TEST_F(MotorTest, ATorqueThatIsNotANumberIsRefused) {
  CaptureStderr();
  motor().setTorque(NAN);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("setTorque(NaN) of ArmLowerR"));
  EXPECT_EQ(commanded(kElbow).set, 0);
}

TEST_F(MotorTest, WhatIsNotANumberLeavesEverySettingAsItWas) {
  const auto stays = [this](const char* call, void (*set)(webots::Motor&)) {
    const JointCommand before = commanded(kElbow);
    CaptureStderr();
    set(motor());
    EXPECT_THAT(GetCapturedStderr(), HasSubstr(std::string{call} + "(NaN) of ArmLowerR")) << call;
    const JointCommand after = commanded(kElbow);
    EXPECT_EQ(after.set, before.set) << call;
    EXPECT_THAT(after.goal.value, NanSensitiveDoubleEq(before.goal.value)) << call;
    EXPECT_EQ(after.torque_on, before.torque_on) << call;
    EXPECT_THAT(after.torque_limit.value, NanSensitiveDoubleEq(before.torque_limit.value)) << call;
    EXPECT_THAT(after.speed_limit.value, NanSensitiveDoubleEq(before.speed_limit.value)) << call;
    EXPECT_EQ(after.p_gain, before.p_gain) << call;
  };
  motor().setControlPID(8, 0, 0);
  motor().setTorque(0.05);
  stays("setControlPID", [](webots::Motor& one) { one.setControlPID(NAN, 0, 0); });
  stays("setPosition", [](webots::Motor& one) { one.setPosition(NAN); });
  motor().setPosition(INFINITY);
  motor().setVelocity(0.5);
  stays("setVelocity", [](webots::Motor& one) { one.setVelocity(NAN); });
  motor().setPosition(0);
  motor().setAvailableTorque(0);
  stays("setAvailableTorque", [](webots::Motor& one) { one.setAvailableTorque(NAN); });
  motor().setAvailableTorque(1);
  motor().setAcceleration(1);
  motor().setAcceleration(NAN);
  EXPECT_EQ(motor().getAcceleration(), 1);
}

TEST_F(MotorTest, OnlyPOfThePidCounts) {
  CaptureStderr();
  motor().setControlPID(10, 0, 0);
  EXPECT_EQ(GetCapturedStderr(), "");
  EXPECT_EQ(commanded(kElbow).p_gain, 10);
  CaptureStderr();
  motor().setControlPID(10, 1, 0);
  motor().setControlPID(10, 0, 1);
  const std::string said = GetCapturedStderr();
  EXPECT_EQ(said, "darwinop: setControlPID() of ArmLowerR: i and d have no effect on this robot, only p has\n");
}

TEST_F(MotorTest, ANegativePIsIgnoredAndASmallOneWarnsButCounts) {
  CaptureStderr();
  motor().setControlPID(-1, 0, 0);
  EXPECT_EQ(commanded(kElbow).set, 0);
  motor().setControlPID(1, 0, 0);
  EXPECT_EQ(commanded(kElbow).p_gain, 1);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("p under 3"));
}

TEST_F(MotorTest, AnAccelerationRaisesTheSpeedLimitStepByStepUpToTheVelocity) {
  motor().setVelocity(1);
  motor().setAcceleration(10);
  motor().setPosition(joint().position.value - 1);
  double previous = 0;
  for (int step = 1; step <= 10; ++step) {
    const double limit = commanded(kElbow).speed_limit.value;
    EXPECT_NEAR(limit, std::min(1.0, step * 0.16), 1e-9);
    EXPECT_GE(limit, previous);
    previous = limit;
  }
}

TEST_F(MotorTest, TheEndOfAnAccelerationRestoresTheVelocity) {
  motor().setVelocity(3);
  motor().setAcceleration(1);
  motor().setPosition(0.5);
  EXPECT_LT(commanded(kElbow).speed_limit.value, 1);
  motor().setAcceleration(-1);
  EXPECT_EQ(commanded(kElbow).speed_limit.value, 3);
  EXPECT_EQ(motor().getAcceleration(), -1);
}

TEST_F(MotorTest, TheEndOfAnAccelerationWithoutVelocityIsFullSpeed) {
  motor().setAcceleration(1);
  motor().setPosition(0.5);
  EXPECT_LT(commanded(kElbow).speed_limit.value, 1);
  motor().setAcceleration(-1);
  EXPECT_EQ(commanded(kElbow).speed_limit.value, motor().getMaxVelocity());
}

TEST_F(MotorTest, AnAccelerationGivenInEveryStepStillRises) {
  motor().setPosition(joint().position.value - 1);
  for (int i = 0; i < 5; ++i) {
    motor().setAcceleration(10);
    commanded(kElbow);
  }
  EXPECT_NEAR(fake.last().joint[index(kElbow)].speed_limit.value, 0.8, 1e-9);
}

TEST_F(MotorTest, AnAccelerationThatIsSwitchedOnAgainStartsAtRest) {
  motor().setPosition(joint().position.value - 1);
  motor().setAcceleration(2);
  for (int i = 0; i < 20; ++i) commanded(kElbow);
  motor().setAcceleration(-1);
  commanded(kElbow);
  motor().setAcceleration(2);
  EXPECT_NEAR(commanded(kElbow).speed_limit.value, 0.032, 1e-9);
}

TEST_F(MotorTest, LimitsAreTheJointTableExactly) {
  EXPECT_DOUBLE_EQ(motor().getMinPosition(), (970 - 2048) * 2 * M_PI / 4096);
  EXPECT_DOUBLE_EQ(motor().getMaxPosition(), (2804 - 2048) * 2 * M_PI / 4096);
}

TEST_F(MotorTest, PositionsAreExact) {
  joint().position = radFromTicks(2373);
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_DOUBLE_EQ(motor().getPosition(), 325 * 2 * M_PI / 4096);
  EXPECT_DOUBLE_EQ(robot().getPositionSensor("ArmLowerRS")->getValue(), motor().getPosition());
}

TEST_F(MotorTest, TorqueFeedbackHasTheSignOf2013) {
  joint().load = -0.5;  // clockwise
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_DOUBLE_EQ(motor().getTorqueFeedback(), 1.25);
  EXPECT_DOUBLE_EQ(motor().getForceFeedback(), 1.25);
}

TEST_F(MotorTest, MissingDataIsNaNAfterThreeCyclesAndNamedOnce) {
  robot();
  joint().motion.age = 3;
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_FALSE(std::isnan(motor().getPosition()));
  joint().motion.age = 4;
  EXPECT_EQ(robot().step(16), 0);
  CaptureStderr();
  EXPECT_TRUE(std::isnan(motor().getPosition()));
  EXPECT_TRUE(std::isnan(motor().getTorqueFeedback()));
  EXPECT_TRUE(std::isnan(motor().getPosition()));
  EXPECT_EQ(
      GetCapturedStderr(),
      "darwinop: ArmLowerR has not answered for more than 3 cycles: its values are NaN (not a number) until it does\n");
  joint().motion.age = 0;
  EXPECT_EQ(robot().step(16), 0);
  EXPECT_FALSE(std::isnan(motor().getPosition()));
}

TEST_F(MotorTest, AJointThatNeverAnsweredIsNaNFromTheStart) {
  joint() = JointSensors{};
  EXPECT_TRUE(std::isnan(motor().getPosition()));
  EXPECT_TRUE(std::isnan(robot().getPositionSensor("ArmLowerRS")->getValue()));
  EXPECT_DOUBLE_EQ(motor().getTargetPosition(), radFromTicks(2380).value) << "then it is the start pose";
}

TEST_F(MotorTest, ServoIsTheSameMotorUnderItsFirstName) {
  webots::Servo* servo = robot().getServo("ArmLowerR");
  ASSERT_NE(servo, nullptr);
  EXPECT_EQ(servo, robot().getMotor("ArmLowerR"));
  servo->setMotorForce(1);
  servo->setControlP(5);
  const JointCommand command = commanded(kElbow);
  EXPECT_EQ(command.torque_limit.value, 1);
  EXPECT_EQ(command.p_gain, 5);
  servo->enableMotorForceFeedback(32);
  servo->enablePosition(48);
  EXPECT_EQ(servo->getMotorForceFeedbackSamplingPeriod(), 32);
  EXPECT_EQ(servo->getSamplingPeriod(), 48);
}

TEST_F(MotorTest, MotorAndSensorKnowEachOther) {
  EXPECT_EQ(motor().getPositionSensor(), robot().getPositionSensor("ArmLowerRS"));
  EXPECT_EQ(motor().getPositionSensor()->getMotor(), &motor());
}

}  // namespace
}  // namespace darwinop::webots_api
