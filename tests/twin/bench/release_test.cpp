// An arm let go: viscous and dry friction have amplitudes in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

constexpr Pendulum kPendulum{.payload_kg = 0.3, .length_m = 0.12};

// Angles of the turning points, as amounts, until it rests. A turn is within a step: off by w' h^2 / 8 at most, 1e-5.
std::vector<double> amplitudes(Bench& bench, double seconds) {
  std::vector<double> found;
  double before = 0;
  while (bench.time_s() < seconds) {
    const double at = bench.position_rad();
    bench.step(kLimp);
    const double now = bench.velocity_rad_s();
    if (now == 0) break;
    if (before * now < 0) found.push_back(std::abs(at));
    before = now;
  }
  found.push_back(std::abs(bench.position_rad()));
  return found;
}

// What a swing loses is friction times way, at any amplitude: W (cos q2 - cos q1) = F (q1 + q2).
TEST(Release, DryFrictionTakesItsTorqueTimesTheWay) {
  Bench bench{ServoParameters{}, friction(0.02, 0), kPendulum};
  bench.reset({.start_rad = 1.5});
  const std::vector<double> q = amplitudes(bench, 30);
  ASSERT_GT(q.size(), 10U);
  double before = 1.5, total = 0;
  for (std::size_t i = 0; i + 1 < q.size(); ++i) {
    const double lost = bench.weight_nm() * (std::cos(q[i]) - std::cos(before));
    EXPECT_NEAR(lost, 0.02 * (before + q[i]), 1e-5) << "swing " << i;
    total += lost;
    before = q[i];
  }
  EXPECT_GT(total, 0.2);
}

// Small swings: x = (x - F/W) exp(-pi zeta) - F/W from turn to turn, so linear for F alone, exponential for viscous
// alone. Of amplitude 0.1 the sine is off by 0.2 %, of which a swing feels a part.
TEST(Release, SmallSwingsShrinkByExponentialAndLinearTogether) {
  for (const auto& [dry, viscous] : {std::pair{0.0005, 0.0}, {0.0, 0.002}, {0.0005, 0.002}}) {
    Bench bench{ServoParameters{}, friction(dry, viscous), kPendulum};
    bench.reset({.start_rad = 0.1});
    const std::vector<double> q = amplitudes(bench, 4);
    ASSERT_GT(q.size(), 7U);
    const double w = std::sqrt(bench.weight_nm() / bench.inertia_kgm2());
    const double zeta = viscous / (2 * bench.inertia_kgm2() * w), step = dry / bench.weight_nm();
    double x = 0.1;
    for (std::size_t i = 0; i < 7; ++i) {
      x = (x - step) * std::exp(-kPi * zeta / std::sqrt(1 - zeta * zeta)) - step;
      EXPECT_NEAR(q[i], x, 1e-4) << "turn " << i << " dry " << dry << " viscous " << viscous;
    }
  }
}

TEST(Release, RestsWhereFrictionHoldsItAndNotAtTheLowestPoint) {
  Bench bench{ServoParameters{}, friction(0.025, 0.002), kArm};
  bench.reset({.start_rad = kPi / 2});
  run(bench, kLimp, 10);
  const double rest = bench.position_rad();
  EXPECT_EQ(bench.velocity_rad_s(), 0);
  EXPECT_GT(std::abs(rest), 1e-3);
  EXPECT_LE(bench.weight_nm() * std::sin(std::abs(rest)), 0.025);
  run(bench, kLimp, 100);
  EXPECT_EQ(bench.position_rad(), rest);
}

}  // namespace
}  // namespace darwinop::twin::testing
