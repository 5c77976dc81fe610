// Walks of slow controllers in the twin.
#include <gtest/gtest.h>

#include "twin_walk_rig.hpp"

namespace managers {
namespace {

constexpr double kTilted = 0.9;  // cosine of the tilt; a fall goes below 0.3

class SlowWalkInTheTwin : public testing::TestWithParam<int> {};

TEST_P(SlowWalkInTheTwin, StaysUpright) {
  TwinWalk walk;
  walk.start(1);
  walk.loop(TwinWalk::kStance);
  walk.loop(30, GetParam());
  EXPECT_GT(walk.lowest(), kTilted);
  EXPECT_GT(walk.body().trunkPosition()[0], 2) << "m";
}

INSTANTIATE_TEST_SUITE_P(Rounds, SlowWalkInTheTwin, testing::Values(16, 24, 32, 40, 64, 80));

TEST(RobotStyleInTheTwin, NeedsNoStepOfTheManagerInCodeOfTheRobot) {
  TwinWalk walk;
  walk.start(1);
  walk.loop(TwinWalk::kStance + 5, TwinWalk::kStepMs, false);
  EXPECT_GT(walk.body().trunkPosition()[0], 0.3) << "m";
  EXPECT_GT(walk.lowest(), kTilted);
}

}  // namespace
}  // namespace managers
