// When held-out recordings on the floor confirm names.
#include "gap/identify/body/floor_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace darwinop::gap {
namespace {

FloorErrors joints(double mrad) {
  return {.joints = mrad / 1000, .gyro = 0.07, .accel = 0.5};
}

TEST(FloorErrors, NamesHaveToExplainHalfOfTheHeldOutGap) {
  EXPECT_TRUE(isVerified(joints(4.37), joints(2.04), false));
  EXPECT_FALSE(isVerified(joints(4.37), joints(2.30), false));
}

TEST(FloorErrors, WithinThreeFloorsNothingIsLeftToExplain) {
  EXPECT_TRUE(isVerified(joints(2.2), joints(1.8), false)) << "an encoder's noise is 0.64 mrad";
}

TEST(FloorErrors, SensorsAreJudgedByTheGyroscope) {
  const FloorErrors before{.joints = 0.02, .gyro = 1.0, .accel = 1}, after{.joints = 0.02, .gyro = 0.4, .accel = 1};
  EXPECT_TRUE(isVerified(before, after, true));
  EXPECT_FALSE(isVerified(before, after, false)) << "the joints have not moved";
}

TEST(FloorErrors, WithoutHeldOutRecordingsNothingContradicts) {
  EXPECT_TRUE(
      isVerified({.joints = NAN, .gyro = NAN, .accel = NAN}, {.joints = NAN, .gyro = NAN, .accel = NAN}, false));
}

}  // namespace
}  // namespace darwinop::gap
