// The motion of the goal: within its limits, without overshoot, exactly there, in the time of a trapezoid.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "twin/servo/profile.hpp"

namespace darwinop::twin {
namespace {

constexpr double kPeriod = 0.001;
constexpr double kNone = std::numeric_limits<double>::infinity();

double within(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1000001) / 1e6;
}

// Periods until it is there for good; the profile is fed its own set point.
int periodsTo(double goal, double speed, double accel) {
  Profile profile;
  double set_point = 0;
  int periods = 0;
  while (set_point != goal && periods < 1000000) {
    set_point = profile.advance(set_point, goal, speed, accel, kPeriod);
    ++periods;
  }
  return periods;
}

TEST(Profile, TakesTheTimeOfATrapezoid) {
  for (const auto& [way, speed, accel] : {std::array{1.6, 1.0, 5.0}, {3.0, 5.76, 38.0}, {-1.0, 2.0, 10.0}}) {
    // The last period is rounded up, and so is the one in which it turns from speeding up to slowing down.
    EXPECT_NEAR(periodsTo(way, speed, accel) * kPeriod, std::abs(way) / speed + speed / accel, 2 * kPeriod);
  }
}

TEST(Profile, TakesTheTimeOfATriangleWhenTheWayIsShort) {
  EXPECT_NEAR(periodsTo(0.1, kNone, 10) * kPeriod, 2 * std::sqrt(0.1 / 10), 2 * kPeriod);
}

TEST(Profile, WithoutAccelerationLimitItIsARampAndWithoutAnyAJump) {
  EXPECT_EQ(periodsTo(1, 2, kNone), 500);
  EXPECT_EQ(periodsTo(1, kNone, kNone), 1);
}

TEST(Profile, AZeroLimitHoldsItsPlace) {
  Profile profile;
  EXPECT_EQ(profile.advance(0.3, 1, 0, kNone, kPeriod), 0.3);
  EXPECT_EQ(profile.advance(0.3, 1, 0, 5, kPeriod), 0.3);
  EXPECT_EQ(profile.advance(0.3, 1, kNone, 0, kPeriod), 0.3);
}

// The goal may jump at any time; what was left when it stops jumping is reached exactly.
RC_GTEST_PROP(ProfileProperty, KeepsItsLimitsAndArrivesExactly, ()) {
  const double speed = within(0.1, 12), accel = within(1, 200);
  Profile profile;
  double set_point = within(-3, 3), velocity = 0;
  for (int jump = *rc::gen::inRange(0, 4); jump >= 0; --jump) {
    const double goal = within(-3, 3);
    const int periods = jump == 0 ? 200000 : *rc::gen::inRange(1, 500);
    for (int i = 0; i < periods && !(jump == 0 && set_point == goal && profile.velocity_rad_s() == 0); ++i) {
      set_point = profile.advance(set_point, goal, speed, accel, kPeriod);
      RC_ASSERT(std::abs(profile.velocity_rad_s()) <= speed * (1 + 1e-12));
      RC_ASSERT(std::abs(profile.velocity_rad_s() - velocity) <= accel * kPeriod * (1 + 1e-9));
      velocity = profile.velocity_rad_s();
    }
    if (jump == 0) {
      RC_ASSERT(set_point == goal);
    }
  }
}

RC_GTEST_PROP(ProfileProperty, FromRestItNeverOvershoots, ()) {
  const double speed = within(0.1, 12), accel = within(1, 2000), goal = within(-3, 3);
  Profile profile;
  double set_point = 0;
  for (int i = 0; i < 100000 && set_point != goal; ++i) {
    const double next = profile.advance(set_point, goal, speed, accel, kPeriod);
    RC_ASSERT((next - set_point) * goal > 0);
    RC_ASSERT(std::abs(next) <= std::abs(goal));  // to the last bit
    set_point = next;
  }
  RC_ASSERT(set_point == goal);
}

}  // namespace
}  // namespace darwinop::twin
