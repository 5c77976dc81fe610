// Direction of the trunk by its accelerometer.
#include "gap/live/trunk_direction.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/units.hpp"

namespace darwinop::gap::live {
namespace {

TEST(TrunkDirection, IsAgainstGravity) {
  TrunkDirection direction;
  EXPECT_FALSE(direction.up());
  direction.add({0, kGravity, 0}, 0);
  EXPECT_EQ(*direction.up(), (Axes{0, 1, 0})) << "upright";
  direction.forget();
  direction.add({0, 0, -kGravity}, 0);
  EXPECT_EQ(*direction.up(), (Axes{0, 0, -1})) << "face down";
  EXPECT_TRUE(direction.isSteady());
  direction.add({std::nan(""), 0, 0}, 1);
  EXPECT_EQ(*direction.up(), (Axes{0, 0, -1})) << "not read";
}

TEST(TrunkDirection, AStandIsExactAHeldTrunkIsNot) {
  EXPECT_EQ(alongAxis({0.1, 0.99, -0.05}), (Axes{0, 1, 0}));
  const Axes held{0.6, 0.8, 0};
  EXPECT_EQ(alongAxis(held), held);
}

TEST(TrunkDirection, ARobotOnTheFloorLeansForwardsOrLies) {
  EXPECT_NEAR(*forwardLean({0, std::cos(0.2), -std::sin(0.2)}), 0.2, 1e-9);
  EXPECT_NEAR(*forwardLean({0, 0, -1}), kPi / 2, 1e-9) << "on its face";
  EXPECT_FALSE(forwardLean({1, 0, 0})) << "on its right side";
}

}  // namespace
}  // namespace darwinop::gap::live
