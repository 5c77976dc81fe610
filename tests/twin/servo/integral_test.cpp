// Start of the integral of a joint that was held before a recording begins.
#include <gtest/gtest.h>

#include <cmath>

#include "twin/servo/bench.hpp"

namespace darwinop::twin::testing {
namespace {

struct Duties {
  double at_start, next;  // right after startIntegralFrom(), and of the next period
};

/// Of a shaft held still, 0.01 rad from its goal.
Duties dutiesFrom(double duty, const ServoDrive& drive, const ServoParameters& parameters = mx28()) {
  Servo servo{parameters, {}};
  servo.reset(0);
  servo.firmware(drive, 0, 0);
  servo.startIntegralFrom(duty);
  const double at_start = servo.signals().duty;
  servo.firmware(drive, 0, 0);
  return {at_start, servo.signals().duty};
}

ServoDrive driveWith(double i_gain) {
  ServoDrive drive = driveTo(0.01);
  drive.i_gain = i_gain;
  return drive;
}

TEST(IntegralStart, TheDutyContinuesFromTheGivenOne) {
  const Duties with = dutiesFrom(0.3, driveWith(1));
  EXPECT_EQ(with.at_start, 0.3);
  EXPECT_NEAR(with.next, 0.3, 1e-3);
  EXPECT_GT(std::abs(dutiesFrom(0.3, driveWith(0)).next - 0.3), 0.1) << "the duty of the proportional term alone";
}

TEST(IntegralStart, ChangesNothingWithoutAnIntegral) {
  const Duties of_law = dutiesFrom(0, driveWith(0));
  EXPECT_EQ(dutiesFrom(0.3, driveWith(0)).at_start, of_law.next);
  ServoDrive limp = driveWith(1);
  limp.torque_on = false;
  EXPECT_EQ(dutiesFrom(0.3, limp).at_start, 0);
  ServoParameters speed_law = mx28();
  speed_law.law = Law::kSpeedP;
  EXPECT_EQ(dutiesFrom(0.3, driveWith(1), speed_law).at_start, 0);
}

TEST(IntegralStart, TheDutyStaysWithinItsLimit) {
  ServoDrive weak = driveWith(1);
  weak.torque_limit = 0.2;
  EXPECT_EQ(dutiesFrom(0.9, weak).at_start, 0.2);
}

}  // namespace
}  // namespace darwinop::twin::testing
