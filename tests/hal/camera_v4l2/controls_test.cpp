// Which controls are written.
#include "hal/camera_v4l2/controls.hpp"

#include <gtest/gtest.h>

namespace darwinop::v4l2 {
namespace {

using What = ControlDecision::What;

TEST(Controls, AreWrittenOnlyWhenTheyDiffer) {
  EXPECT_EQ(decide(40, {0, 255, 128, 40}).what, What::kLeave);
  const ControlDecision decision = decide(41, {0, 255, 128, 40});
  EXPECT_EQ(decision.what, What::kWrite);
  EXPECT_EQ(decision.value, 41);
}

TEST(Controls, GoToTheDriversDefaultForMinusOne) {
  const ControlDecision decision = decide(CameraSettings::kDriversDefault, {0, 255, 128, 40});
  EXPECT_EQ(decision.what, What::kWrite);
  EXPECT_EQ(decision.value, 128);
  EXPECT_EQ(decide(CameraSettings::kDriversDefault, {0, 255, 40, 40}).what, What::kLeave);
}

TEST(Controls, StayWithinTheDriversRange) {
  EXPECT_EQ(decide(0, {1, 100, 50, 50}).what, What::kOutOfRange);
  EXPECT_EQ(decide(1, {1, 100, 50, 50}).what, What::kWrite);
  EXPECT_EQ(decide(100, {1, 100, 50, 50}).what, What::kWrite);
  EXPECT_EQ(decide(101, {1, 100, 50, 50}).what, What::kOutOfRange);
}

}  // namespace
}  // namespace darwinop::v4l2
