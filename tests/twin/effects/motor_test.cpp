// What effects do to supply and motor.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

/// With all the duty that there is, the horn held at 0 or turning at this speed.
Actuation fullDuty(Servo& servo, double speed_rad_s = 0) {
  servo.firmware(driveTo(3), 0, speed_rad_s);
  return servo.actuate(0, speed_rad_s, 0);
}

double stallTorque(const std::vector<Chosen>& choice) {
  Servo servo = servoWith(choice);
  return fullDuty(servo).torque_nm;
}

double noLoadSpeed(const std::vector<Chosen>& choice) {
  Servo servo = servoWith(choice);
  const Actuation out = fullDuty(servo);
  return out.torque_nm / out.damping_nms_rad;
}

TEST(SupplySag, LowersTheVoltageByTheCurrentThatTheBridgeDraws) {
  for (const double speed : {0.0, 2.0, 4.0}) {
    Servo servo = servoWith({{"supply_sag", {{"resistance", 2}}}});
    fullDuty(servo, speed);
    const Signals& s = servo.signals();
    EXPECT_GT(s.current_a, 0.2);
    EXPECT_NEAR(s.supply_v, 12 - 2 * s.duty * s.current_a, 1e-9);
    EXPECT_NEAR(servo.report().supply_v, s.supply_v, 1e-12) << "the register shows it";
  }
}

TEST(SupplySag, GrowsWithTheSquareOfTheLoad) {
  const auto sag_at = [](double goal) {
    Servo servo = servoWith({{"supply_sag", {{"resistance", 0.1}}}});
    servo.firmware(driveTo(goal), 0, 0);
    return 12 - servo.signals().supply_v;
  };
  // The resistance of the cables is a hundredth of the winding's, so much may it be off from the square.
  EXPECT_NEAR(sag_at(0.16) / sag_at(0.08), 4, 0.05);
}

TEST(SupplySag, CountsTheCurrentThatATorqueLimitLeaves) {
  Servo servo = servoWith({{"supply_sag", {{"resistance", 2}}}, {"torque_limit", {{"torque", 0.5}}}});
  fullDuty(servo);
  EXPECT_NEAR(servo.signals().supply_v, 12 - 2 * 0.5 / ServoParameters{}.kt_nm_a, 1e-9);
}

TEST(SupplySag, DroopsOverTheSession) {
  Servo servo = servoWith({{"supply_sag", {{"droop", 0.005}}}});
  servo.reset(0, 100);
  servo.firmware(driveTo(0), 0, 0);
  EXPECT_NEAR(servo.signals().supply_v, 12 - 0.5, 1e-4);
}

TEST(SupplySag, EndsWithAnEmptyBatteryAndTurnsNothingRound) {
  Servo servo = servoWith({{"supply_sag", {{"droop", 0.01}}}});
  servo.reset(0, 2000);
  servo.firmware(driveTo(0.5), 0, 0);
  EXPECT_EQ(servo.signals().supply_v, 0);
  EXPECT_EQ(servo.actuate(0, 0, 0).torque_nm, 0);
}

TEST(KtError, MakesTheMotorStrongerAndSlower) {
  const std::vector<Chosen> choice{{"kt_error", {{"change", 0.08}}}};
  EXPECT_NEAR(stallTorque(choice) / stallTorque({}), 1.08, 1e-9);
  EXPECT_NEAR(noLoadSpeed(choice) / noLoadSpeed({}), 1 / 1.08, 1e-9);
}

TEST(KtError, ItsSecondNumberTouchesTheBackEmfAlone) {
  const std::vector<Chosen> choice{{"kt_error", {{"back_emf", 0.1}}}};
  EXPECT_NEAR(stallTorque(choice), stallTorque({}), 1e-12);
  EXPECT_NEAR(noLoadSpeed(choice) / noLoadSpeed({}), 1 / 1.1, 1e-9);
}

TEST(ResistanceError, ScalesEveryTorqueAndLeavesTheTopSpeed) {
  const std::vector<Chosen> choice{{"resistance_error", {{"change", 0.1}}}};
  EXPECT_NEAR(stallTorque(choice) / stallTorque({}), 1 / 1.1, 1e-9);
  EXPECT_NEAR(noLoadSpeed(choice), noLoadSpeed({}), 1e-9);
}

TEST(Cogging, IsLockedToTheAngleAndTheSameAtAllSpeeds) {
  Servo servo = servoWith({{"cogging", {{"amplitude", 0.03}, {"count", 20}, {"phase", 0.4}}}});
  for (int i = -100; i < 100; ++i) {
    const double q = 0.01 * i;
    for (const double speed : {0.0, 5.0})
      EXPECT_NEAR(servo.actuate(q, speed, 0).torque_nm, 0.03 * std::sin(20 * q + 0.4), 1e-12);
  }
  EXPECT_NEAR(servo.actuate(0.3 + 2 * std::numbers::pi / 20, 0, 0).torque_nm, servo.actuate(0.3, 0, 0).torque_nm,
              1e-12);
}

}  // namespace
}  // namespace darwinop::twin
