// First goal of a joint when a motion takes over.
#include "core/goals/present_goal.hpp"

#include <gtest/gtest.h>

namespace darwinop::goals {
namespace {

JointSensors at(double commanded, double position) {
  JointSensors joint;
  joint.commanded = Rad{commanded};
  joint.position = Rad{position};
  return joint;
}

TEST(PresentGoal, IsTheGoalNearThePosition) {
  EXPECT_EQ(presentGoal(Joint::kNeck, at(0.5, 0.3), 1), 0.5);
  EXPECT_EQ(presentGoal(Joint::kNeck, at(0.5, kUnknown), 1), 0.5);
}

TEST(PresentGoal, IsAtMostFullPullFromThePosition) {
  EXPECT_EQ(presentGoal(Joint::kNeck, at(1, 0), 1), kFullPull);
  EXPECT_EQ(presentGoal(Joint::kNeck, at(-1, 0), 1), -kFullPull);
}

TEST(PresentGoal, OfALimpJointIsItsPosition) {
  EXPECT_EQ(presentGoal(Joint::kNeck, at(kUnknown, 0.3), 1), 0.3);
}

TEST(PresentGoal, OfAnUnknownJointIsTheRequestedGoalOrItsStartPose) {
  const double start = radFromTicks(row(Joint::kLegLowerR).start).value;
  EXPECT_GT(std::abs(start), 0.5);
  EXPECT_EQ(presentGoal(Joint::kLegLowerR, {}, INFINITY), start);
  EXPECT_EQ(presentGoal(Joint::kLegLowerR, {}, NAN), start);
  EXPECT_EQ(presentGoal(Joint::kLegLowerR, {}, 0.2), 0.2);
}

}  // namespace
}  // namespace darwinop::goals
