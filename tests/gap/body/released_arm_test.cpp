// Numbers of a limb that falls limp.
#include <gmock/gmock.h>

#include <algorithm>

#include "gap/benchmark/body/body_suite.hpp"
#include "gap/localize/body/close_by_numbers.hpp"

namespace darwinop::gap {
namespace {

constexpr double kOpenFrom = 3.7;  // sigma, of 92 signals

// An arm that is released falls 0.4 rad off where friction, masses and motor are off within their priors.
TEST(ReleasedArm, IsLikeItsModelOnceTheNumbersAre) {
  const BodyRequest request = bodyRequests(2026, BodyPart::kEffectFree).at(7);
  ASSERT_TRUE(request.wrong_numbers);
  const BodyCase given = hiddenBody(request).given;
  ClampedRobot robot{given};
  const std::size_t arm = robot.limbOf(Joint::kShoulderR);
  const auto significance = [&] {
    return std::ranges::max(limbRows(robot, arm, robot.baseline()), {}, &BodyRow::significance).significance;
  };
  ASSERT_GT(significance(), 30);
  EXPECT_TRUE(closeByNumbers(robot, {arm}, robot.baseline(), kOpenFrom));
  EXPECT_LT(significance(), kOpenFrom);
}

// A long free swing of a released arm: twelve simulated falls do not span a thirteenth.
TEST(ReleasedArm, HasNoGapWhereNoSimulatedFallIsLikeIt) {
  const BodyRequest request = bodyRequests(2026, BodyPart::kPairs).at(2);
  const BodyCase given = hiddenBody(request).given;
  const ClampedRobot robot{given};
  const std::size_t arm = robot.limbOf(Joint::kShoulderR);
  const auto rows = limbRows(robot, arm, robot.baseline());
  EXPECT_LT(std::ranges::max(rows, {}, &BodyRow::significance).significance, kOpenFrom);
}

}  // namespace
}  // namespace darwinop::gap
