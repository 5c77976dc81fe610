// The motor at the horn: data sheet figures and closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

// A stick of no mass but a weight at its end, held out sideways.
Pendulum weighing(double weight_nm) {
  return {.payload_kg = weight_nm / 9.80665, .length_m = 1};
}

// Full duty upward from 90 degrees: how far it got in half a second.
double riseUnder(double weight_nm) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), weighing(weight_nm)};
  bench.reset({.start_rad = kPi / 2});
  run(bench, driveTo(kPi, 100), 0.5);
  return bench.position_rad() - kPi / 2;
}

// 2.5 N m, and friction of 0.025 N m that stands against both directions. Each load is 0.6 % from the edge.
TEST(ServoMotor, LiftsWhatTheDataSheetSaysAndHoldsWhatFrictionAdds) {
  EXPECT_GT(riseUnder(2.460), 1e-3);
  EXPECT_EQ(riseUnder(2.490), 0);
  EXPECT_EQ(riseUnder(2.510), 0);
  EXPECT_LT(riseUnder(2.540), -1e-3);
}

TEST(ServoMotor, StallsAtOnePointFourAmpere) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), weighing(2.5)};
  bench.reset({.start_rad = kPi / 2});
  run(bench, driveTo(kPi, 100), 0.1);
  EXPECT_NEAR(bench.servo().signals().current_a, 1.4, 1e-9);  // at rest: no rounding but the arithmetic's
  EXPECT_NEAR(bench.servo().signals().motor_torque_nm, 2.5, 1e-9);
}

TEST(ServoMotor, RunsAtFiftyFiveRpmWithoutLoad) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), {.payload_kg = 0}};
  run(bench, driveTo(1000), 1);
  EXPECT_NEAR(bench.velocity_rad_s(), kNoLoad, 1e-6);
}

// w(t) = w_end (1 - exp(-t / tau)): the kick is the closed solution, so the tolerance is that of rounding.
TEST(ServoMotor, SpeedsUpWithTheTimeConstantOfInertiaAndBackEmf) {
  const ServoParameters p = mx28();
  Bench bench{p, friction(0, kViscous), {.payload_kg = 0}};
  const double damping = p.kt_nm_a * p.back_emf_vs_rad / p.resistance_ohm + kViscous;
  const double tau = p.armature_kgm2 / damping, end = 2.5 / damping;
  ASSERT_GT(tau, 0.006);
  ASSERT_LT(tau, 0.008);
  for (const double t : {0.001, 0.007, 0.02, 0.1}) {
    bench.reset({});
    run(bench, driveTo(1000), t);
    EXPECT_NEAR(bench.velocity_rad_s(), end * (1 - std::exp(-t / tau)), 1e-9) << "after " << t << " s";
  }
}

// load = duty_per_kp * P register * error * stall torque. Without friction; the encoder rounds by half a tick, and the
// position may stand anywhere within the tick.
TEST(ServoMotor, DroopsByLoadOverGain) {
  for (const double kp : {1.0, 2.0, 4.0, 8.0}) {
    Bench bench{mx28(), friction(0, kViscous), {.payload_kg = 0.4, .length_m = 0.12}};
    run(bench, driveTo(1.0, kp), 3);
    const double gain = 0.158 * 8 * kp * 2.5;
    const double droop = bench.weight_nm() * std::sin(bench.position_rad()) / gain;
    EXPECT_NEAR(1.0 - bench.position_rad(), droop, kRadPerTick) << "Kp " << kp;
  }
}

// The other torque of the model: a limp servo is an open bridge.
TEST(ServoMotor, BrakesNothingWithTorqueOff) {
  Bench bench{mx28(), {}, {.payload_kg = 0}};
  bench.reset({.start_rad_s = 3});
  run(bench, kLimp, 1);
  EXPECT_EQ(bench.velocity_rad_s(), 3);
  EXPECT_EQ(bench.servo().signals().current_a, 0);
}

TEST(ServoMotor, TorqueLimitIsAShareOfTheStallTorque) {
  for (const double limit : {0.1, 0.5}) {
    Bench bench{mx28(), {}, {.payload_kg = 3, .length_m = 0.1}};
    ServoDrive drive = driveTo(3, 100);
    drive.torque_limit = limit;
    run(bench, drive, 3);  // the weight swings out, and settles where the torque holds it
    EXPECT_NEAR(bench.weight_nm() * std::sin(bench.position_rad()), 2.5 * limit, 1e-4) << limit;
  }
}

}  // namespace
}  // namespace darwinop::twin::testing
