// What effects do to the position controller.
#include <gtest/gtest.h>

#include <cmath>

#include "core/conversions.hpp"
#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

const double kSlope = ServoParameters{}.duty_per_kp_per_rad * 32;  // duty per rad at the usual gain

/// Duty at this error, at rest, both as exact multiples of the encoder's step.
double dutyAt(Servo& servo, int error_ticks) {
  servo.reset(0);
  servo.firmware(driveTo(error_ticks * kRadPerTick), 0, 0);
  return servo.signals().duty;
}

TEST(Deadband, GivesNoDutyWithinAndTheRestOfTheErrorBeyond) {
  Servo servo = servoWith({{"deadband", {{"width", 10.5 * kRadPerTick}}}});
  for (int error = -40; error <= 40; ++error) {
    const double beyond = std::max(0.0, std::abs(error) - 10.5) * kRadPerTick;
    EXPECT_NEAR(dutyAt(servo, error), std::copysign(kSlope * beyond, error), 1e-12) << error;
  }
}

TEST(Deadband, PunchesWhereItStarts) {
  Servo servo = servoWith({{"deadband", {{"width", 10.5 * kRadPerTick}, {"punch", 0.05}}}});
  EXPECT_EQ(dutyAt(servo, 10), 0);
  EXPECT_NEAR(dutyAt(servo, 11), 0.05 + kSlope * 0.5 * kRadPerTick, 1e-12);
  EXPECT_NEAR(dutyAt(servo, -11), -0.05 - kSlope * 0.5 * kRadPerTick, 1e-12);
}

TEST(KpScale, ScalesTheSlopeOfDutyOverError) {
  Servo servo = servoWith({{"kp_scale", {{"scale", 0.7}}}});
  for (const int error : {-30, -1, 1, 30}) EXPECT_NEAR(dutyAt(servo, error), 0.7 * kSlope * error * kRadPerTick, 1e-12);
}

double droopAfter(double seconds, const std::vector<Chosen>& choice, double p_gain = 4, Law law = Law::kVoltageP) {
  ServoParameters parameters;
  parameters.law = law;
  Bench bench{parameters, effectsOf(choice), kArm};
  ServoDrive drive = driveTo(1);
  drive.p_gain = p_gain;
  runFor(bench, seconds, drive);
  return 1 - bench.position_rad();
}

TEST(Integral, TakesAwayWhatIsMissingUnderLoad) {
  const double without = droopAfter(5, {});
  const double with = droopAfter(5, {{"integral", {{"gain", 4}}}});
  // Held by the P gain alone: load / stall torque / slope = 0.41 / 2.5 / 5.06.
  EXPECT_NEAR(without, 0.033, 0.003);
  EXPECT_NEAR(with, 0, 2 * kRadPerTick) << "the encoder resolves no better";
}

TEST(Derivative, AnswersTheChangeOfTheError) {
  Servo servo = servoWith({{"derivative", {{"gain", 0.05}}}});
  servo.firmware(driveTo(0), 0, 0);
  servo.firmware(driveTo(kRadPerTick), 0, 0);
  const double kick = 8 * ServoParameters{}.duty_per_kp_per_rad * 0.05 * kRadPerTick / 0.001;
  EXPECT_NEAR(servo.signals().duty, kSlope * kRadPerTick + kick, 1e-12);
  servo.firmware(driveTo(kRadPerTick), 0, 0);
  EXPECT_NEAR(servo.signals().duty, kSlope * kRadPerTick, 1e-12) << "a constant error has no change";
}

TEST(TorqueLimit, CapsTheDutyAndShowsItAsLoad) {
  Servo servo = servoWith({{"torque_limit", {{"duty", 0.3}}}});
  EXPECT_NEAR(dutyAt(servo, 1000), 0.3, 1e-12);
  EXPECT_NEAR(dutyAt(servo, -1000), -0.3, 1e-12);
  EXPECT_NEAR(servo.report().load, -0.3, 1e-12);
  EXPECT_NEAR(dutyAt(servo, 5), 5 * kRadPerTick * kSlope, 1e-12) << "smaller ones pass";
}

TEST(TorqueLimit, LeavesALowerLimitOfTheRegisterAlone) {
  Servo servo = servoWith({{"torque_limit", {{"duty", 0.3}}}});
  ServoDrive weak = driveTo(1);
  weak.torque_limit = 0.1;
  servo.firmware(weak, 0, 0);
  EXPECT_NEAR(servo.signals().duty, 0.1, 1e-12);
}

TEST(TorqueLimit, CapsTheTorqueOfTheMotorAtAnySpeed) {
  Servo servo = servoWith({{"torque_limit", {{"torque", 0.5}}}});
  servo.firmware(driveTo(1), 0, 0);
  for (const double speed : {-2.0, 0.0, 2.0}) {
    const Actuation out = servo.actuate(0, speed, 0);
    EXPECT_NEAR(out.torque_nm - out.damping_nms_rad * speed, 0.5, 1e-12) << speed;
  }
}

// The law of the model file is Webots': with the effect the servo is the real one, to the last bit.
TEST(POnTorque, IsTheLawOfTheRealServo) {
  ServoParameters webots;
  webots.law = Law::kSpeedP;
  Bench real{{}, {}, kArm}, swapped{webots, effectsOf({{"p_on_torque", {{"on", 1}}}}), kArm};
  ServoDrive drive = driveTo(0.9);
  drive.accel_limit_rad_s2 = 50;
  for (int i = 0; i < 1000; ++i) {
    if (i == 700) drive.torque_on = false;
    real.step(drive);
    swapped.step(drive);
    ASSERT_EQ(real.position_rad(), swapped.position_rad()) << i;
    ASSERT_EQ(real.servo().report().load, swapped.servo().report().load) << i;
  }
}

// The finding of 2013: in the simulator the arm always arrives, on the robot it stops short the more the smaller P is.
TEST(POnTorque, StopsShortInProportionToLoadOverP) {
  for (const double p_gain : {1.0, 2.0, 4.0}) {
    EXPECT_NEAR(droopAfter(8, {}, p_gain, Law::kSpeedP), 0, 2 * kRadPerTick);
    const double droop = droopAfter(8, {{"p_on_torque", {{"on", 1}}}}, p_gain, Law::kSpeedP);
    const double load = Bench{{}, {}, kArm}.weight_nm() * std::sin(1 - droop) / 2.5;  // share of the stall torque
    EXPECT_NEAR(droop, load / (8 * p_gain * ServoParameters{}.duty_per_kp_per_rad), kRadPerTick);
  }
}

}  // namespace
}  // namespace darwinop::twin
