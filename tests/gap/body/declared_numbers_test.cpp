// Effects that are numbers of the model gain no more than their priors cost.
#include "gap/identify/body/declared_numbers.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "gap/body/moving_robot.hpp"

namespace darwinop::gap {
namespace {

constexpr double kDeclared = 0.025;  // N m, of shippedRobot()

PlacedMechanics placed(std::string_view id, std::vector<Joint> joints, std::vector<double> values) {
  const MechanicalEffect& effect = *std::ranges::find(mechanicalEffects(), id, &MechanicalEffect::id);
  values.resize(effect.numbers.size(), 0.0);
  return {&effect, std::move(joints), std::move(values)};
}

struct DeclaredNumbers : testing::Test {
  DeclaredNumbers() { given.trust = {{"friction", 0.2}, {"body.mass", 0.03}, {"body.com_m", 0.002}}; }
  BodyCase given = movingRobot(shippedRobot());
};

TEST_F(DeclaredNumbers, AFrictionCostsItsSquaredDistanceFromTheDeclaredOneInEachJoint) {
  const ClampedRobot robot{given};
  EXPECT_NEAR(priorCost(robot, placed("coulomb", {Joint::kNeck}, {0.6 * kDeclared})), 9, 1e-9);
  EXPECT_NEAR(priorCost(robot, placed("coulomb", {Joint::kArmUpperR, Joint::kArmUpperL}, {0.2 * kDeclared})), 2, 1e-9);
}

TEST_F(DeclaredNumbers, AShiftOfACentreOfMassCostsItsLengthAndAMassItsShareOfTheLink) {
  const ClampedRobot robot{given};
  EXPECT_NEAR(priorCost(robot, placed("link_com", {Joint::kHead}, {0.002, 0, 0.004})), 5, 1e-9);
  const double one = priorCost(robot, placed("link_mass", {Joint::kHead}, {0.01}));
  EXPECT_GT(one, 0);
  EXPECT_NEAR(priorCost(robot, placed("link_mass", {Joint::kHead}, {0.02})), 4 * one, 1e-9);
}

TEST_F(DeclaredNumbers, WhatTheModelHasNoNumberForAndAnExactModelLimitNothing) {
  EXPECT_TRUE(std::isinf(priorCost(ClampedRobot{given}, placed("backlash", {Joint::kNeck}, {0.02}))));
  given.trust.clear();
  EXPECT_TRUE(std::isinf(priorCost(ClampedRobot{given}, placed("coulomb", {Joint::kNeck}, {0.005}))));
}

TEST_F(DeclaredNumbers, MovedNumbersOfAnotherFrictionExplainItsMotion) {
  BodyHypothesis hidden = shippedRobot();
  hidden.servos
      .with(*twin::findEffect("coulomb"), {.kind = Place::Kind::kJoint, .name = std::string{row(Joint::kNeck).name}})
      .values = {2 * kDeclared};
  given = movingRobot(hidden);
  given.trust = {{"friction", 0.6}};
  ClampedRobot robot{given};
  const std::size_t limb = robot.limbOf(Joint::kNeck);
  const double before = robot.residuals(limb).of(robot.baseline()).squaredNorm();
  moveNumbers(robot, placed("coulomb", {Joint::kNeck}, {kDeclared}), robot.baseline());
  EXPECT_LT(robot.residuals(limb).of(robot.baseline()).squaredNorm(), before);
}

}  // namespace
}  // namespace darwinop::gap
