// Convergence of the bench with the number of mechanical steps per firmware period: one is accurate enough.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "twin/bench/near_sine.hpp"
#include "twin/servo/bench.hpp"

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
ServoDrive released(double) {
  return kLimp;
}

// Encoder quantization limits the accuracy on a step: a tick seen one period later exceeds the integration error.
TEST(StepSize, OneStepIsWithinATenthOfATickOfFiftyOnAStep) {
  EXPECT_LT(furthestApart(kFriction, -0.8, stepUp, 2, 1, 50), 0.1 * kRadPerTick);
}

TEST(StepSize, OneStepIsWithinATenthOfATickOfFiftyOnARelease) {
  EXPECT_LT(furthestApart(kFriction, kPi / 2, released, 6, 1, 50), 0.1 * kRadPerTick);
}

// Half the step, a quarter of the error, on a smooth motion.
TEST(StepSize, ErrorShrinksWithTheSquareOfTheStep) {
  const auto smooth = [] { return friction(0, 0.002); };
  const double two = furthestApart(smooth, 1.5, released, 2, 2, 64),
               four = furthestApart(smooth, 1.5, released, 2, 4, 64);
  EXPECT_NEAR(two / four, 4, 0.1);  // the reference of 64 steps has 1/1024 of the error of two
}

// Friction that depends on speed and load is also evaluated at the middle of the step.
TEST(StepSize, SpeedDependentFrictionIsOfTheSecondOrder) {
  const auto rough = [] {
    Effects effects = friction(0, kViscous);
    effects.push_back(effect("stribeck", {0.05, 2}));
    return effects;
  };
  // Until the first reversal: there friction is discontinuous.
  const double one = furthestApart(rough, 1.5, released, 0.4, 1, 64),
               two = furthestApart(rough, 1.5, released, 0.4, 2, 64);
  EXPECT_NEAR(one / two, 4, 0.6);
  EXPECT_LT(one, 0.02 * kRadPerTick);
}

TEST(StepSize, StickAndSlipCostsLessThanAFifthOfATick) {
  const auto rough = [] {
    Effects effects = friction(kCoulomb, kViscous);
    effects.push_back(effect("stribeck", {0.05, 0.2}));
    return effects;
  };
  EXPECT_LT(furthestApart(rough, -0.8, stepUp, 2, 1, 50), 0.2 * kRadPerTick);
  EXPECT_LT(furthestApart(rough, kPi / 2, released, 6, 1, 50), 0.2 * kRadPerTick);
}

TEST(StepSize, FrictionByLoadCostsLessThanATenthOfATick) {
  const auto rough = [] {
    Effects effects = friction(kCoulomb, kViscous);
    effects.push_back(effect("load_dependent_friction", {0.05}));
    return effects;
  };
  EXPECT_LT(furthestApart(rough, -0.8, stepUp, 2, 1, 50), 0.1 * kRadPerTick);
  EXPECT_LT(furthestApart(rough, kPi / 2, released, 6, 1, 50), 0.1 * kRadPerTick);
}

// Law speed_p: the commanded speed is constant for a period and reached in one step of that length.
TEST(StepSize, WebotsLawReachesItsSpeedInASeparateStep) {
  ServoParameters webots;
  webots.law = Law::kSpeedP;
  webots.accel_max_rad_s2 = 55;
  EXPECT_LT(furthestApart(kFriction, -0.8, stepUp, 2, 2, 50, webots), 0.1 * kRadPerTick);
}

TEST(NearSine, EqualsStdSinIndependentOfEarlierCalls) {
  NearSine sine;
  for (double angle = -7, step = 1e-5; angle < 7; angle += step, step *= 1.01)
    ASSERT_NEAR(sine(angle), std::sin(angle), 4e-16) << angle;
  EXPECT_NEAR(sine(-3), std::sin(-3), 4e-16);
  EXPECT_TRUE(std::isnan(sine(std::nan(""))));
  EXPECT_NEAR(sine(0.5), std::sin(0.5), 4e-16) << "a NaN has no effect on later calls";
}

}  // namespace
}  // namespace darwinop::twin::testing
