// Controllers that end while they walk in the twin: on a level floor, pushed, and downhill.
#include <gtest/gtest.h>

#include <tuple>

#include "twin_ground.hpp"

namespace managers {
namespace {

/// Twelfths of a gait period of 600 ms.
class EndInTheTwin : public testing::TestWithParam<std::tuple<Ground, int>> {};

TEST_P(EndInTheTwin, KneelsFromBothFeet) {
  const auto [ground, moment] = GetParam();
  TwinWalk walk;
  walkOn(walk, ground, moment * 0.05);
  ASSERT_GT(walk.lowest(), kFallen) << "it walks";
  walk.end();
  runToRest(walk, 500);
  EXPECT_EQ(walk.state(), darwinop::State::kLimp) << "sits, released";
  EXPECT_GT(walk.lowest(), kFallen);
}

// At 3 and 9, on one foot, a robot that kneels at once falls on each ground.
INSTANTIATE_TEST_SUITE_P(Moments, EndInTheTwin,
                         testing::Combine(testing::Values(Ground::kLevel, Ground::kPush, Ground::kSlope),
                                          testing::Values(0, 3, 9)));

}  // namespace
}  // namespace managers
