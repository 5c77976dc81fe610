// Walks of slow and of ending controllers in the twin.
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

/// Moments over one gait period of 600 ms, cycles after the first steps.
class EndInTheTwin : public testing::TestWithParam<int> {};

TEST_P(EndInTheTwin, KneelsFromBothFeet) {
  TwinWalk walk;
  walk.start(1);
  walk.loop(TwinWalk::kStance + 2 + GetParam() * 0.016);
  walk.end();
  walk.runLoop(500);
  EXPECT_EQ(walk.state(), darwinop::State::kLimp) << "sits, released";
  EXPECT_GT(walk.lowest(), kTilted);
}

INSTANTIATE_TEST_SUITE_P(Moments, EndInTheTwin, testing::Values(0, 6, 12, 18, 24, 30));

}  // namespace
}  // namespace managers
