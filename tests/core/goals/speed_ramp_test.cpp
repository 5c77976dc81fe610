// The speed limit of a joint with an acceleration, and a servo that follows it.
#include "core/goals/speed_ramp.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace darwinop::goals {
namespace {

constexpr double kStep = 0.016;

/// A joint at 0 that moves, so that only the distance counts.
double next(SpeedRamp& ramp, double cruise, double acceleration, double distance) {
  JointSensors seen;
  seen.position = Rad{0};
  seen.velocity = RadPerSec{0.5};
  return ramp.next(cruise, acceleration, Rad{distance}, seen, kStep);
}

TEST(SpeedRamp, RisesToCruiseAndFallsBeforeTheGoal) {
  SpeedRamp ramp;
  double position = 0, fastest = 0, before = 0;
  int steps = 0;
  for (; std::abs(1 - position) > 0.005 && steps < 1000; ++steps) {
    const double speed = next(ramp, 2, 8, 1 - position);
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
  for (int i = 0; i < 10; ++i) static_cast<void>(next(ramp, 5, 10, 2));
  EXPECT_DOUBLE_EQ(next(ramp, 5, 10, -2), 0.16);
}

TEST(SpeedRamp, StartsAgainFromRestAtTheGoal) {
  SpeedRamp ramp;
  for (int i = 0; i < 10; ++i) static_cast<void>(next(ramp, 5, 10, 2));
  static_cast<void>(next(ramp, 5, 10, 0));
  EXPECT_LE(next(ramp, 5, 10, 2), 2 * 0.16 + 1e-9);
}

/// Below its goal by 40 ticks: with the P gain of 4 that is 0.4 N m.
TEST(SpeedRamp, StartsAgainFromRestUnderLoad) {
  SpeedRamp ramp;
  JointSensors seen;
  seen.position = Rad{1 - 40 * kRadPerTick};
  seen.velocity = RadPerSec{0};
  for (int i = 0; i < 100; ++i) static_cast<void>(ramp.next(5, 1, Rad{1}, seen, kStep));
  EXPECT_DOUBLE_EQ(ramp.next(5, 1, Rad{2}, seen, kStep), 0.016);
  EXPECT_DOUBLE_EQ(ramp.next(5, 1, Rad{2}, seen, kStep), 0.032);
}

/// A controller that computes a new goal in every step: the joint starts late, and the limit rises nevertheless.
TEST(SpeedRamp, RisesAlthoughTheGoalChangesBeforeTheJointMoves) {
  SpeedRamp ramp;
  JointSensors seen;
  seen.position = Rad{0};
  seen.velocity = RadPerSec{0};
  double speed = 0;
  for (int i = 0; i < 10; ++i) speed = ramp.next(5, 1, Rad{1 + 0.01 * i}, seen, kStep);
  EXPECT_DOUBLE_EQ(speed, 0.16);
}

TEST(SpeedRamp, IsNeverAboveCruise) {
  SpeedRamp ramp;
  for (int i = 0; i < 100; ++i) EXPECT_LE(next(ramp, 0.05, 100, 3), 0.05);
}

TEST(SpeedRamp, RisesWithoutKnowingThePosition) {
  SpeedRamp ramp;
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_DOUBLE_EQ(next(ramp, 5, 10, unknown), 0.16);
  EXPECT_DOUBLE_EQ(next(ramp, 5, 10, unknown), 0.32);
}

}  // namespace
}  // namespace darwinop::goals
