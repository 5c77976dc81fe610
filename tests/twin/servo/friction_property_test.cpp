// Friction takes energy and gives none, and what rests stays, at any state.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

double within(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

// Without gravity there is nothing but friction: to the last bit, no step speeds it up.
RC_GTEST_PROP(Friction, OnlySlowsDownWhereNothingElseActs, ()) {
  const double dry = within(0, 0.3), viscous = within(0, 0.2), speed = within(-15, 15);
  Bench bench{ServoParameters{},
              friction(dry, viscous),
              {.payload_kg = within(0, 0.5), .length_m = within(0, 0.2), .gravity_m_s2 = 0}};
  bench.reset({.steps_per_period = *rc::gen::inRange(1, 6), .start_rad_s = speed});
  double before = bench.energy_j();
  for (int i = 0; i < 500; ++i) {
    bench.step(kLimp);
    RC_ASSERT(bench.energy_j() <= before);
    RC_ASSERT(bench.velocity_rad_s() * speed >= 0);
    before = bench.energy_j();
  }
  // F stops J w in J w / F at the latest; a step for rounding.
  if (dry > 0 && bench.inertia_kgm2() * std::abs(speed) / dry < 0.499) {
    RC_ASSERT(bench.velocity_rad_s() == 0);
  }
}

// With gravity the scheme's own energy breathes by (w h)^2 / 8 of what is in it; friction adds nothing to that.
RC_GTEST_PROP(Friction, NeverAddsEnergyToASwing, ()) {
  const Pendulum pendulum{.payload_kg = within(0.05, 0.5), .length_m = within(0.05, 0.2)};
  Bench bench{ServoParameters{}, friction(within(0, 0.1), within(0, 0.05)), pendulum};
  bench.reset({.start_rad = within(-3, 3), .start_rad_s = within(-10, 10)});
  const double wh2 = bench.weight_nm() / bench.inertia_kgm2() * 0.0005 * 0.0005;
  double least = bench.energy_j();
  for (int i = 0; i < 2000; ++i) {
    bench.step(kLimp);
    const double kinetic = bench.inertia_kgm2() * bench.velocity_rad_s() * bench.velocity_rad_s() / 2;
    RC_ASSERT(bench.energy_j() <= least + wh2 * (kinetic + 2 * bench.weight_nm()));
    least = std::min(least, bench.energy_j());
  }
}

// Load below the threshold, from gravity and motor together: not one bit, for as long as it lasts.
RC_GTEST_PROP(Friction, HoldsARestingJointUnderEveryLoadBelowIt, ()) {
  const double start = within(-3, 3), dry = within(0.01, 0.3);
  const double weight = 0.49 * dry / std::max(0.01, std::abs(std::sin(start)));
  Bench bench{mx28(), friction(dry, within(0, 0.05)), {.payload_kg = weight / 9.80665, .length_m = 1}};
  bench.reset({.start_rad = start});
  const double away = 0.49 * dry / (0.158 * 32 * 2.5) - kRadPerTick;  // an error that pushes with the other half
  const ServoDrive drive = driveTo(start + (away > 0 ? within(-away, away) : 0));
  const bool powered = away > 0 && *rc::gen::arbitrary<bool>();
  for (int i = 0; i < 1000; ++i) {
    bench.step(powered ? drive : kLimp);
    RC_ASSERT(bench.position_rad() == start);
    RC_ASSERT(bench.velocity_rad_s() == 0);
  }
}

// And above it, it goes, in the direction of the load.
RC_GTEST_PROP(Friction, LetsGoAboveIt, ()) {
  const double start = within(0.1, 3), dry = within(0.01, 0.3), weight = 1.02 * dry / std::sin(start);
  Bench bench{ServoParameters{}, friction(dry, 0), {.payload_kg = weight / 9.80665, .length_m = 1}};
  bench.reset({.start_rad = start});
  run(bench, kLimp, 0.005);
  RC_ASSERT(bench.position_rad() < start);
}

}  // namespace
}  // namespace darwinop::twin::testing
