// Invalid bench parameters: error messages. Repeatability of runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(BenchErrors, NameTheValueAndTheAllowedRange) {
  const auto make = [](const Pendulum& pendulum) { Bench{ServoParameters{}, {}, pendulum}; };
  EXPECT_THAT([&] { make({.payload_kg = -0.1}); },
              ThrowsMessage<std::runtime_error>(HasSubstr("payload (kg) is -0.1")));
  EXPECT_THAT([&] { make({.length_m = NAN}); }, ThrowsMessage<std::runtime_error>(HasSubstr("length (m)")));
  ServoParameters light;
  light.armature_kgm2 = 0;
  EXPECT_THAT([&] { (Bench{light, {}, {.payload_kg = 0}}); }, ThrowsMessage<std::runtime_error>(HasSubstr(kNoInertia)));
  Bench bench{ServoParameters{}, {}, {}};
  EXPECT_THAT([&] { bench.reset({.steps_per_period = 0}); },
              ThrowsMessage<std::runtime_error>(HasSubstr(kTooFewSteps)));
}

TEST(BenchRuns, AreBitwiseRepeatable) {
  const auto end = [] {
    Bench bench{mx28(), friction(kCoulomb, kViscous), kArm};
    run(bench, driveTo(0.8), 0.3);
    bench.reset({.start_rad = -0.3});  // clears all history
    run(bench, driveTo(0.5), 0.2);
    run(bench, kLimp, 0.2);
    return bench.position_rad();
  };
  EXPECT_EQ(end(), end());
  Bench fresh{mx28(), friction(kCoulomb, kViscous), kArm};
  fresh.reset({.start_rad = -0.3});
  run(fresh, driveTo(0.5), 0.2);
  run(fresh, kLimp, 0.2);
  EXPECT_EQ(fresh.position_rad(), end());
}

}  // namespace
}  // namespace darwinop::twin::testing
