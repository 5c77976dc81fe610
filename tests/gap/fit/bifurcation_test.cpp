// Repeats of a release that come to rest in different places: how much of them counts as noise.
#include <gtest/gtest.h>

#include <limits>

#include "gap/fit/noise.hpp"
#include "gap/small_case.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kRelease = 2;
constexpr double kApart = 0.05;  // rad between two places of rest
constexpr double kParts = 2;     // s

/// The bench with friction, and a second run of its release that comes to rest `aside_rad` away.
Case releasedTwice(double aside_rad, double warmer_c = 0) {
  Case bench = smallBench();
  bench.model.effects.push_back({.info = twin::findEffect("coulomb"), .values = {0.05}, .joint = {}});
  bench.logs[kRelease] = commanded(
      "release", 5, 16, 0.3, [](double) { return 1.2; }, 0.5);
  bench.logs.push_back(bench.logs[kRelease]);
  bench.logs.back().repeat_of = kRelease;
  Case given = measured(bench, baselineOf(bench), 3);
  Trajectory& again = given.logs.back();
  for (std::size_t row = 0; row < again.rows(); ++row)
    if (again.time_s[row] > kParts) again.position_rad[row] += aside_rad;
  for (double& temperature : again.temp_c) temperature += warmer_c;
  return given;
}

LogNoise noiseOfRelease(const Case& given) {
  return {plantOf(given), given, kRelease, baselineOf(given), {.runs = 24, .disturbance = {}}};
}

TEST(Bifurcation, RowsAfterTheRunsPartCountLess) {
  const LogNoise usual = noiseOfRelease(releasedTwice(0)), split = noiseOfRelease(releasedTwice(kApart));
  EXPECT_FALSE(usual.bifurcates());
  ASSERT_TRUE(split.bifurcates());
  const Eigen::VectorXd before = usual.positionSigma(), after = split.positionSigma();
  // Two runs: each is half of it from their mean, which is a standard deviation of 1 / root 2 of it.
  EXPECT_NEAR(after[after.size() - 5], kApart / std::sqrt(2), 0.3 * kApart);
  EXPECT_LT(before[before.size() - 5], 0.2 * kApart);
  const auto row = static_cast<Eigen::Index>((kParts - 0.2) / kRow);
  EXPECT_NEAR(after[row], before[row], 0.2 * before[row]) << "before they part";
}

TEST(Bifurcation, AWarmerServoThatRestsElsewhereIsAGap) {
  constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(noiseOfRelease(releasedTwice(kApart, 8)).bifurcates());
  EXPECT_FALSE(noiseOfRelease(releasedTwice(kApart, kUnknown)).bifurcates());
  EXPECT_FALSE(noiseOfRelease(releasedTwice(0.002)).bifurcates()) << "within what the model expects";
}

TEST(Bifurcation, AHeldOutRepeatHasNoPartInTheNoiseOfAFit) {
  Case given = releasedTwice(kApart);
  given.logs.back().held_out = true;
  EXPECT_FALSE(noiseOfRelease(given).bifurcates());
  given.logs[kRelease].held_out = true;
  EXPECT_TRUE(noiseOfRelease(given).bifurcates());
}

// A release is the place to see where a joint rests: under torque a difference is the servo's.
TEST(Bifurcation, NeedsAReleasedJoint) {
  Case given = releasedTwice(kApart);
  given.logs.back().torque_on.assign(given.logs.back().rows(), 1);
  EXPECT_FALSE(noiseOfRelease(given).bifurcates());
}

}  // namespace
}  // namespace darwinop::gap
