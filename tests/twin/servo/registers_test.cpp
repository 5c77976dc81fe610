// What a servo's registers show, and what its gains do.
#include <gtest/gtest.h>

#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

TEST(ServoRegisters, PositionIsTheNearestTick) {
  Bench bench{mx28(), {}, {.payload_kg = 0}};
  for (const double q : {0.0, 0.1, -0.7, 3.0, -3.14159}) {
    bench.reset({.start_rad = q});
    bench.step(kLimp);
    const double ticks = bench.servo().report().position_rad / kRadPerTick;
    EXPECT_NEAR(ticks, std::nearbyint(ticks), 1e-9);
    EXPECT_LE(std::abs(bench.servo().report().position_rad - q), kRadPerTick / 2 + 1e-12);
  }
}

// The way over 24 ms in whole ticks: within one tick per 24 ms, and late by 12 ms.
TEST(ServoRegisters, PresentSpeedIsTheWayOverTwentyFourMilliseconds) {
  for (const double period : {0.001, 0.0001}) {
    ServoParameters p = mx28();
    p.firmware_period_s = period;
    Bench bench{p, {}, {.payload_kg = 0}};
    bench.reset({.start_rad_s = 2});
    for (double t = 0; t < 0.012 - period / 2; t += period) bench.step(kLimp);
    EXPECT_NEAR(bench.servo().report().velocity_rad_s, 1, kRadPerTick / 0.024 + 2 * period / 0.024);
    for (double t = 0; t < 0.1; t += period) bench.step(kLimp);
    EXPECT_NEAR(bench.servo().report().velocity_rad_s, 2, kRadPerTick / 0.024);
  }
}

// No torque sensor: the register shows the duty, positive pushes counter-clockwise.
TEST(ServoRegisters, PresentLoadIsTheDutyWithItsSign) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), kArm};
  run(bench, driveTo(kPi / 2), 3);
  const double up = bench.servo().report().load;
  EXPECT_EQ(up, bench.servo().signals().duty);
  EXPECT_NEAR(up, bench.weight_nm() / 2.5, kCoulomb / 2.5 + 0.158 * 32 * kRadPerTick);
  run(bench, driveTo(-kPi / 2), 3);
  EXPECT_NEAR(bench.servo().report().load, -up, 2 * kCoulomb / 2.5 + 0.158 * 32 * kRadPerTick);
  bench.step(kLimp);
  EXPECT_EQ(bench.servo().report().load, 0);
}

TEST(ServoRegisters, IntegralGainTakesTheDroopAway) {
  Bench bench{mx28(), {}, kArm};
  ServoDrive drive = driveTo(1.2, 2);
  run(bench, drive, 2);
  const double droop = 1.2 - bench.position_rad();
  EXPECT_GT(droop, 10 * kRadPerTick);
  drive.i_gain = 16 * 1000.0 / 2048;
  run(bench, drive, 4);
  EXPECT_NEAR(bench.position_rad(), 1.2, 2 * kRadPerTick);  // it hunts within the ticks beside the goal
}

// Ki = I * 1000 / 2048 per second, in the scale of Kp: at Kp = Ki * 1 s an error that stands for a second pushes as
// much again.
TEST(ServoRegisters, IntegralGrowsByKiPerSecond) {
  Bench bench{mx28(), friction(3, 0), {.payload_kg = 0}};  // friction that nothing moves
  ServoDrive drive = driveTo(100 * kRadPerTick, 0.5);
  bench.step(drive);
  const double at_once = bench.servo().signals().duty;
  drive.i_gain = 0.5;
  run(bench, drive, 1);
  EXPECT_NEAR(bench.servo().signals().duty, 2 * at_once, 1e-9);
  EXPECT_NEAR(at_once, 0.158 * 4 * 100 * kRadPerTick, 1e-9);
}

TEST(ServoRegisters, DerivativeGainPushesAgainstMotion) {
  Bench bench{mx28(), {}, {.payload_kg = 0, .gravity_m_s2 = 0}};
  bench.reset({.start_rad_s = 2});
  ServoDrive drive = driveTo(0, 0);
  drive.d_gain = 0.1;
  run(bench, drive, 0.002);
  // A tick and 2 mrad in a millisecond are 1 or 2 ticks: -Kd * speed, in ticks a period.
  const double tick_duty = 8 * 0.158 * 0.1 * kRadPerTick / 0.001;
  const double duty = bench.servo().signals().duty;
  EXPECT_LE(duty, -tick_duty + 1e-9);
  EXPECT_GE(duty, -2 * tick_duty - 1e-9);
}

// Switched on again it starts from where it was pushed to, and with an empty integral.
TEST(ServoRegisters, TorqueComingOnForgetsTheOldGoal) {
  Bench bench{mx28(), friction(0.3, 0), {.payload_kg = 0, .gravity_m_s2 = 0}};
  run(bench, driveTo(1), 1);
  bench.step(kLimp);
  ServoDrive slow = driveTo(-1);
  slow.speed_limit_rad_s = 0.5;
  bench.step(slow);
  EXPECT_NEAR(bench.servo().signals().set_point_rad, bench.position_rad(), 2 * kRadPerTick);
}

}  // namespace
}  // namespace darwinop::twin::testing
