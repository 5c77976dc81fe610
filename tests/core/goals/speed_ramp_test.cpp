// The speed limit of a joint with an acceleration, and a servo that follows it.
#include "core/goals/speed_ramp.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace darwinop::goals {
namespace {

constexpr double kStep = 0.016;

TEST(SpeedRamp, RisesToCruiseAndFallsBeforeTheGoal) {
  SpeedRamp ramp;
  double position = 0, fastest = 0, before = 0;
  int steps = 0;
  for (; std::abs(1 - position) > 0.005 && steps < 1000; ++steps) {
    const double speed = ramp.next(2, 8, 1 - position, kStep);
    EXPECT_LE(speed - before, 8 * kStep + 1e-9);
    EXPECT_GE(speed, 8 * kStep - 1e-9) << "never so slow that the joint stays";
    fastest = std::max(fastest, speed);
    before = speed;
    position += speed * kStep;
  }
  EXPECT_DOUBLE_EQ(fastest, 2);
  EXPECT_LT(before, 0.5) << "arrives slowly";
  EXPECT_NEAR(steps * kStep, 1.0 / 2 + 2.0 / 8, 0.1) << "a trapezoid: distance / speed + speed / acceleration";
}

TEST(SpeedRamp, StartsAgainWhenTheDirectionChanges) {
  SpeedRamp ramp;
  for (int i = 0; i < 10; ++i) static_cast<void>(ramp.next(5, 10, 2, kStep));
  EXPECT_DOUBLE_EQ(ramp.next(5, 10, -2, kStep), 0.16);
}

TEST(SpeedRamp, StartsAgainFromRestAtTheGoal) {
  SpeedRamp ramp;
  for (int i = 0; i < 10; ++i) static_cast<void>(ramp.next(5, 10, 2, kStep));
  static_cast<void>(ramp.next(5, 10, 0, kStep));
  EXPECT_LE(ramp.next(5, 10, 2, kStep), 2 * 0.16 + 1e-9);
}

TEST(SpeedRamp, IsNeverAboveCruise) {
  SpeedRamp ramp;
  for (int i = 0; i < 100; ++i) EXPECT_LE(ramp.next(0.05, 100, 3, kStep), 0.05);
}

TEST(SpeedRamp, RisesWithoutKnowingThePosition) {
  SpeedRamp ramp;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(ramp.next(5, 10, unknown, kStep), 0.16);
  EXPECT_DOUBLE_EQ(ramp.next(5, 10, unknown, kStep), 0.32);
}

}  // namespace
}  // namespace darwinop::goals
