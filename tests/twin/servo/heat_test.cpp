// Temperature and overload of a servo that is held fast.
#include <gtest/gtest.h>

#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

// Held by friction that nothing overcomes.
Bench blocked() {
  return Bench{mx28(), friction(10, 0), {.payload_kg = 0}};
}

ServoDrive pushing(double limit) {
  ServoDrive drive = driveTo(3, 100);
  drive.torque_limit = limit;
  return drive;
}

// 1.4 A in 8.57 ohm are 16.8 W; in 8 K/W and 60 J/K: 134 K with a time constant of 480 s. Explicit steps of 1 ms are
// exact to a millionth.
TEST(ServoHeat, StalledItWarmsAsOneBody) {
  Bench bench = blocked();
  run(bench, pushing(1), 60);
  const double end = 1.4 * 1.4 * 12 / 1.4 * 8, tau = 480;
  EXPECT_NEAR(bench.servo().report().temperature_c, 25 + end * (1 - std::exp(-60 / tau)), 0.01);
  const double warm = bench.servo().report().temperature_c - 25;
  run(bench, kLimp, 60);
  EXPECT_NEAR(bench.servo().report().temperature_c, 25 + warm * std::exp(-60 / tau), 0.01);
}

TEST(ServoHeat, OverloadTripsAfterTwoSecondsAtTheLimit) {
  for (const double limit : {1.0, 0.5}) {
    Bench bench = blocked();
    run(bench, pushing(limit), 1.999);
    EXPECT_FALSE(bench.servo().report().overload);
    bench.step(pushing(limit));
    EXPECT_TRUE(bench.servo().report().overload) << limit;
  }
}

TEST(ServoHeat, OverloadStandsUntilTorqueIsOff) {
  Bench bench = blocked();
  run(bench, pushing(1), 2.1);
  run(bench, driveTo(0), 1);  // no load any more
  EXPECT_TRUE(bench.servo().report().overload);
  bench.step(kLimp);
  EXPECT_FALSE(bench.servo().report().overload);
  run(bench, pushing(1), 1.9);
  EXPECT_FALSE(bench.servo().report().overload) << "the time starts anew";
}

TEST(ServoHeat, WhatIsHeldBelowTheLimitIsNoOverload) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), {.payload_kg = 1.5, .length_m = 0.15}};  // 2.2 N m
  run(bench, driveTo(kPi / 2, 20), 5);
  ASSERT_GT(bench.servo().report().load, 0.8);
  EXPECT_FALSE(bench.servo().report().overload);
}

// Running at full duty is what a servo is made for.
TEST(ServoHeat, FullSpeedIsNoOverload) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), {.payload_kg = 0}};
  run(bench, driveTo(1000), 5);
  ASSERT_EQ(bench.servo().report().load, 1);
  EXPECT_FALSE(bench.servo().report().overload);
}

// The experiment of 2013: arm down, goal up, torque limit raised slowly from nothing. No servo tripped.
TEST(ServoHeat, RaisingTheTorqueLimitSlowlyUnderTheArmIsNoOverload) {
  Bench bench{mx28(), friction(kCoulomb, kViscous), kArm};
  for (double limit = 0; limit < 0.2; limit += 0.02) {
    run(bench, pushing(limit), 2.5);
    ASSERT_FALSE(bench.servo().report().overload) << "at " << limit;
  }
  EXPECT_GT(bench.position_rad(), 2.9);  // it did come up
}

}  // namespace
}  // namespace darwinop::twin::testing
