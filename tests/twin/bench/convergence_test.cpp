// One mechanical step in a firmware period is as good as fifty.
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
ServoDrive letGo(double) {
  return kLimp;
}

// The encoder's ticks make a step rough: a tick seen a period later is worth more than the scheme's own error.
TEST(StepSize, OneStepIsWithinATenthOfATickOfFiftyOnAStep) {
  EXPECT_LT(furthestApart(kFriction, -0.8, stepUp, 2, 1, 50), 0.1 * kRadPerTick);
}

TEST(StepSize, OneStepIsWithinATenthOfATickOfFiftyOnARelease) {
  EXPECT_LT(furthestApart(kFriction, kPi / 2, letGo, 6, 1, 50), 0.1 * kRadPerTick);
}

// Twice as fine, four times as near, on a smooth motion.
TEST(StepSize, ErrorShrinksWithTheSquareOfTheStep) {
  const auto smooth = [] { return friction(0, 0.002); };
  const double two = furthestApart(smooth, 1.5, letGo, 2, 2, 64), four = furthestApart(smooth, 1.5, letGo, 2, 4, 64);
  EXPECT_NEAR(two / four, 4, 0.1);  // of 64 steps a part in 1024 is left
}

// Friction that depends on speed and load is taken in the middle of the step, too.
TEST(StepSize, SpeedDependentFrictionIsOfTheSecondOrder) {
  const auto rough = [] {
    Effects effects = friction(0, kViscous);
    effects.push_back(effect("stribeck", {0.05, 2}));
    return effects;
  };
  // Until the first turn: where an arm turns, friction changes at once.
  const double one = furthestApart(rough, 1.5, letGo, 0.4, 1, 64), two = furthestApart(rough, 1.5, letGo, 0.4, 2, 64);
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
  EXPECT_LT(furthestApart(rough, kPi / 2, letGo, 6, 1, 50), 0.2 * kRadPerTick);
}

TEST(StepSize, FrictionByLoadCostsLessThanATenthOfATick) {
  const auto rough = [] {
    Effects effects = friction(kCoulomb, kViscous);
    effects.push_back(effect("load_dependent_friction", {0.05}));
    return effects;
  };
  EXPECT_LT(furthestApart(rough, -0.8, stepUp, 2, 1, 50), 0.1 * kRadPerTick);
  EXPECT_LT(furthestApart(rough, kPi / 2, letGo, 6, 1, 50), 0.1 * kRadPerTick);
}

// Here the commanded speed stands for a period and is reached as soon as the torque allows, in a step of its own.
TEST(StepSize, WebotsLawJumpsInItsPlace) {
  ServoParameters webots;
  webots.law = Law::kSpeedP;
  webots.accel_max_rad_s2 = 55;
  EXPECT_LT(furthestApart(kFriction, -0.8, stepUp, 2, 2, 50, webots), 0.1 * kRadPerTick);
}

TEST(NearSine, IsTheLibrarysSineWhereverItWentBefore) {
  NearSine sine;
  for (double angle = -7, step = 1e-5; angle < 7; angle += step, step *= 1.01)
    ASSERT_NEAR(sine(angle), std::sin(angle), 4e-16) << angle;
  EXPECT_NEAR(sine(-3), std::sin(-3), 4e-16);
  EXPECT_TRUE(std::isnan(sine(std::nan(""))));
  EXPECT_NEAR(sine(0.5), std::sin(0.5), 4e-16) << "a NaN is forgotten";
}

}  // namespace
}  // namespace darwinop::twin::testing
