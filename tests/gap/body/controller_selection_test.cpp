// Effects of command and control law, by the loads of the joints alone.
#include "gap/identify/body/controller_selection.hpp"

#include <gmock/gmock.h>

#include "gap/body/moving_robot.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double kOpenFrom = 3.6;  // sigma: 1 % for 66 rows

BodyHypothesis hiding(std::string_view effect, const std::vector<double>& values, const std::vector<Joint>& joints) {
  BodyHypothesis robot = shippedRobot();
  for (const Joint joint : joints) {
    const Place place{.kind = Place::Kind::kJoint, .name = std::string{row(joint).name}};
    robot.servos.with(*twin::findEffect(effect), place).values = values;
  }
  return robot;
}

std::vector<FoundMechanics> foundIn(const BodyHypothesis& hidden) {
  return identifyControllers(movingRobot(hidden), shippedRobot(), kOpenFrom);
}

struct Hidden {
  const char* effect;
  std::vector<double> values;
  std::vector<Joint> joints;
};
const std::vector<Joint> kHips{Joint::kLegUpperR, Joint::kLegUpperL};

class ControllerEffect : public testing::TestWithParam<Hidden> {};
INSTANTIATE_TEST_SUITE_P(Hidden, ControllerEffect,
                         testing::Values(Hidden{"torque_limit", {0.2, 10}, kHips}, Hidden{"kp_scale", {1.2}, kHips},
                                         Hidden{"gear_scale", {0.95}, {Joint::kNeck}},
                                         Hidden{"deadband", {0.01, 0}, {Joint::kArmLowerL}},
                                         Hidden{"accel_limit", {55}, kHips}),
                         [](const auto& test) { return std::string{test.param.effect}; });

TEST_P(ControllerEffect, IsNamedWithItsPlaceAndNumberWithoutASimulation) {
  const auto& [effect, values, joints] = GetParam();
  const std::vector<FoundMechanics> found = foundIn(hiding(effect, values, joints));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found.front().placed.effect->id, effect);
  EXPECT_THAT(found.front().placed.joints, testing::ElementsAreArray(joints));
  EXPECT_NEAR(found.front().placed.values[0], values[0], 0.01 * values[0]);
  EXPECT_THAT(found.front().rivals, IsEmpty());
}

// Before a recording begins the integral of a held joint has summed up its droop.
TEST(ControllerEffects, AnIntegralIsFoundInAJointThatWasHeldBefore) {
  const std::vector<FoundMechanics> found = foundIn(hiding("integral", {4}, kHips));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_EQ(found.front().placed.effect->id, "integral");
  EXPECT_THAT(found.front().placed.joints, testing::ElementsAreArray(kHips));
  EXPECT_NEAR(found.front().placed.values[0], 4, 0.1);
}

TEST(ControllerEffects, AllJointsAreOneName) {
  std::vector<Joint> all;
  for (std::size_t joint = 0; joint < kJoints; ++joint) all.push_back(static_cast<Joint>(joint));
  const std::vector<FoundMechanics> found = foundIn(hiding("kp_scale", {0.85}, all));
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found.front().placed.joints, SizeIs(kJoints));
}

TEST(ControllerEffects, ALimitIsFoundWhateverElseIsWrongWithTheMotion) {
  BodyHypothesis hidden = hiding("torque_limit", {0.2, 10}, kHips);
  hidden.servos.servo.kt_nm_a *= 0.9;
  hidden.servos.with(*twin::findEffect("coulomb")).values = {0.2};
  const std::vector<FoundMechanics> found = foundIn(hidden);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_NEAR(found.front().placed.values[0], 0.2, 0.002);
}

TEST(ControllerEffects, WhatTheLoadsDoNotShowHasNoName) {
  EXPECT_THAT(foundIn(shippedRobot()), IsEmpty());
  EXPECT_THAT(foundIn(hiding("viscous", {0.1}, {Joint::kNeck})), IsEmpty()) << "friction is behind the law";
}

}  // namespace
}  // namespace darwinop::gap
