// The free pendulum against its closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

// Mean period over `swings`, from upward passes through the lowest point.
double periodOf(Bench& bench, int swings) {
  double first = 0, last = 0, before = bench.position_rad();
  for (int seen = 0; seen <= swings;) {
    bench.step(kLimp);
    const double now = bench.position_rad();
    if (before < 0 && now >= 0) {
      last = bench.time_s() - 0.001 * now / (now - before);
      if (seen++ == 0) first = last;
    }
    before = now;
  }
  return (last - first) / swings;
}

// T = 4 sqrt(J / W) K(sin(q0 / 2)). A central scheme swings too fast by (w h)^2 / 24, here a millionth at most.
TEST(FreePendulum, HasThePeriodOfTheEllipticIntegral) {
  for (const double start : {0.01, 0.5, 1.5, 2.8}) {
    Bench bench{ServoParameters{}, {}, {.payload_kg = 0.3, .arm_mass_kg = 0.05, .length_m = 0.12}};
    bench.reset({.start_rad = start});
    const double expected =
        4 * std::sqrt(bench.inertia_kgm2() / bench.weight_nm()) * std::comp_ellint_1(std::sin(start / 2));
    EXPECT_NEAR(periodOf(bench, 20) / expected, 1, 2e-6) << "released at " << start;
  }
}

TEST(FreePendulum, InertiaIsWeightRodAndArmature) {
  const Pendulum pendulum{.payload_kg = 0.3, .arm_mass_kg = 0.06, .length_m = 0.1};
  const Bench bench{ServoParameters{}, {}, pendulum};
  EXPECT_NEAR(bench.inertia_kgm2(), 0.3 * 0.01 + 0.06 * 0.01 / 3 + 0.003, 1e-15);
  EXPECT_NEAR(bench.weight_nm(), (0.3 * 0.1 + 0.06 * 0.05) * 9.80665, 1e-15);
}

TEST(FreePendulum, LoadChangesMoveMassCentreAndLowestPoint) {
  const Pendulum pendulum{.payload_kg = 0.3, .length_m = 0.1};
  const Bench heavier{ServoParameters{}, with(effect("com_mass", {0.2, 0.01})), pendulum};
  EXPECT_NEAR(heavier.weight_nm(), 0.36 * 0.11 * 9.80665, 1e-15);
  EXPECT_NEAR(heavier.inertia_kgm2(), 0.36 * 0.11 * 0.11 + 0.003, 1e-15);
  Bench tilted{ServoParameters{}, with(effect("encoder_offset", {0.1}), friction(0, 0.05)), pendulum};
  run(tilted, kLimp, 10);
  EXPECT_NEAR(std::abs(tilted.position_rad()), 0.1, 1e-6);
}

// Bounded by (w h)^2 / 8 of the energy, and no drift: the second half of 200 s is no worse than the first.
TEST(FreePendulum, KeepsItsEnergy) {
  Bench bench{ServoParameters{}, {}, {.payload_kg = 0.3, .arm_mass_kg = 0.05, .length_m = 0.12}};
  bench.reset({.start_rad = 2});
  const double start = bench.energy_j();
  double first = 0, second = 0, mean = 0;
  constexpr int kHalf = 100000;
  for (int i = 0; i < 2 * kHalf; ++i) {
    bench.step(kLimp);
    const double off = bench.energy_j() / start - 1;
    double& half = i < kHalf ? first : second;
    half = std::max(half, std::abs(off));
    mean += (i < kHalf ? -off : off) / kHalf;
  }
  EXPECT_LT(first, 5e-6);
  EXPECT_LT(second, 1.01 * first);
  EXPECT_NEAR(mean, 0, 1e-8);
}

}  // namespace
}  // namespace darwinop::twin::testing
