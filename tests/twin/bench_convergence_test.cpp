// Two mechanical steps in a firmware period are as good as fifty.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "servo_bench.hpp"

namespace darwinop::twin::testing {
namespace {

template <class MakeEffects, class Drive>
double furthestApart(MakeEffects&& make, double start, Drive&& drive, double seconds, int coarse, int fine,
                     const ServoParameters& parameters = mx28()) {
  Bench a{parameters, make(), kArm}, b{parameters, make(), kArm};
  a.reset({.steps_per_period = coarse, .start_rad = start});
  b.reset({.steps_per_period = fine, .start_rad = start});
  double worst = 0;
  while (a.time_s() < seconds) {
    a.step(drive(a.time_s()));
    b.step(drive(b.time_s()));
    worst = std::max(worst, std::abs(a.position_rad() - b.position_rad()));
  }
  return worst;
}

const auto kFriction = [] { return friction(kCoulomb, kViscous); };
ServoDrive stepUp(double t) {
  return driveTo(t < 0.2 ? -0.8 : 0.8);
}
ServoDrive letGo(double) {
  return kLimp;
}

// The encoder's ticks make a step rough: a tick seen a period later is worth more than the scheme's own error.
TEST(StepSize, TwoStepsAreWithinATenthOfATickOfFiftyOnAStep) {
  EXPECT_LT(furthestApart(kFriction, -0.8, stepUp, 2, 2, 50), 0.1 * kRadPerTick);
}

TEST(StepSize, TwoStepsAreWithinATenthOfATickOfFiftyOnARelease) {
  EXPECT_LT(furthestApart(kFriction, kPi / 2, letGo, 6, 2, 50), 0.1 * kRadPerTick);
}

// Twice as fine, four times as near, on a smooth motion.
TEST(StepSize, ErrorShrinksWithTheSquareOfTheStep) {
  const auto smooth = [] { return friction(0, 0.002); };
  const double two = furthestApart(smooth, 1.5, letGo, 2, 2, 64), four = furthestApart(smooth, 1.5, letGo, 2, 4, 64);
  EXPECT_NEAR(two / four, 4, 0.1);  // of 64 steps a part in 1024 is left
}

// Friction that depends on speed and load is taken at the speed of the step's beginning: first order, and good enough.
TEST(StepSize, SpeedDependentFrictionCostsLessThanATick) {
  const auto rough = [] {
    Effects effects = friction(kCoulomb, kViscous);
    effects.push_back(effect("stribeck", {0.05, 0.2}));
    effects.push_back(effect("load_dependent_friction", {0.05}));
    return effects;
  };
  EXPECT_LT(furthestApart(rough, -0.8, stepUp, 2, 2, 50), kRadPerTick);
  EXPECT_LT(furthestApart(rough, kPi / 2, letGo, 6, 2, 50), kRadPerTick);
}

// Here the commanded speed stands for a period and is reached in the first of its steps.
TEST(StepSize, WebotsLawLagsByHalfAStep) {
  ServoParameters webots;
  webots.law = Law::kSpeedP;
  webots.accel_max_rad_s2 = 55;
  const double apart = furthestApart(kFriction, -0.8, stepUp, 2, 2, 50, webots);
  EXPECT_LT(apart, kRadPerTick);
}

}  // namespace
}  // namespace darwinop::twin::testing
