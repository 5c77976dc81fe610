// Effects of joints and links while the trunk is clamped.
#include <gmock/gmock.h>
#include <mujoco/mujoco.h>

#include <Eigen/LU>
#include <algorithm>

#include "gap/body/moving_robot.hpp"
#include "gap/identify/body/body_identification.hpp"
#include "gap/identify/body/mechanics_text.hpp"
#include "gap/plant/body/dry_friction.hpp"
#include "gap/plant/body/limb_dynamics.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

Place at(Joint joint) {
  return {.kind = Place::Kind::kJoint, .name = std::string{row(joint).name}};
}

TEST(BodyMechanics, MassMatrixAndGravityOfEachLimbAreThoseOfMuJoCo) {
  const twin::Model model = twin::readModel(twin::findModel("darwin-op"));
  const twin::MjModelPtr m = twin::loadBody(model, false);
  const twin::BodyMap map = twin::mapBody(*m, "test");
  const twin::MjDataPtr d = twin::dataFor(*m, "test");
  std::array<double, kJoints> angles{}, speeds{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    angles[i] = 0.3 * std::sin(static_cast<double>(i) + 1), speeds[i] = 2 * std::cos(3.0 * static_cast<double>(i));
    d->qpos[map.qpos[i]] = angles[i];
    d->qvel[map.dof[i]] = speeds[i];
  }
  mj_forward(m.get(), d.get());
  std::vector<double> mass(static_cast<std::size_t>(m->nv) * static_cast<std::size_t>(m->nv));
  mj_fullM(m.get(), mass.data(), d->qM);
  // Gravity in the trunk's frame.
  mjtNum gravity[3], back[4];
  mju_negQuat(back, d->qpos + map.trunk_qpos + 3);
  mju_rotVecQuat(gravity, m->opt.gravity, back);
  for (const Limb& limb : limbsOf(model)) {
    const auto n = static_cast<Eigen::Index>(limb.size());
    LimbVector position(n), velocity(n);
    const auto joint = [&](Eigen::Index i) {
      return static_cast<std::size_t>(limb[static_cast<std::size_t>(i)].joint);
    };
    for (Eigen::Index i = 0; i < n; ++i) position[i] = angles[joint(i)], velocity[i] = speeds[joint(i)];
    const LimbDynamics found{limb, position, velocity, {gravity[0], gravity[1], gravity[2]}};
    for (Eigen::Index i = 0; i < n; ++i) {
      EXPECT_NEAR(found.bias[i], d->qfrc_bias[map.dof[joint(i)]], 1e-9) << row(limb[0].joint).name << " " << i;
      for (Eigen::Index j = 0; j < n; ++j) {
        const double armature = i == j ? m->dof_armature[map.dof[joint(i)]] : 0;
        EXPECT_NEAR(found.mass(i, j) + armature,
                    mass[static_cast<std::size_t>(map.dof[joint(i)] * m->nv + map.dof[joint(j)])], 1e-9);
      }
    }
  }
}

TEST(BodyMechanics, DryFrictionHoldsOneOfTwoCoupledJointsAndBrakesTheOther) {
  LimbMatrix mass(2, 2);
  mass << 0.01, 0.003, 0.003, 0.005;
  const LimbMatrix inverse = mass.inverse();
  LimbVector free(2), greatest(2), far(2);
  free << 1, 0.02, greatest << 0.001, 0.01, far << 1e9, 1e9;
  JointImpulses impulses{LimbVector::Zero(2), LimbVector::Zero(2)};
  const LimbVector after = withFriction(free, inverse, greatest, -far, far, impulses);
  EXPECT_DOUBLE_EQ(impulses.friction[0], -0.001);
  EXPECT_EQ(after[1], 0);
  EXPECT_LT(std::abs(impulses.friction[1]), 0.01);
  const LimbVector momentum = mass * (after - free);
  EXPECT_NEAR(momentum[0], impulses.friction[0], 1e-9);
  EXPECT_NEAR(momentum[1], impulses.friction[1], 1e-9);
}

TEST(BodyMechanics, ALimbOnSoftGearsBeginsWhereItWasMeasuredAtRest) {
  BodyCase held = movingRobot(shippedRobot());
  for (Trajectory& joint : held.joints.logs) {
    std::ranges::fill(joint.goal_rad, joint.goal_rad.front());
    joint.written_s = joint.read_s = std::vector<double>(joint.rows(), 0.0);
  }
  const std::vector<Limb> limbs = limbsOf(held.joints.model);
  const Limb& arm = *std::ranges::find(limbs, Joint::kShoulderR, [](const Limb& limb) { return limb.front().joint; });
  Trajectory& shoulder = held.joints.logs[static_cast<std::size_t>(Joint::kShoulderR)];
  const double rest = rollOut(held, 0, arm, shippedRobot()).position_rad(0, 0);
  std::ranges::fill(shoulder.position_rad, rest);
  for (const auto& [id, values] : {std::pair{"joint_flex", std::vector{5.0, 0.001}}, {"backlash", {0.03}}}) {
    BodyHypothesis soft = shippedRobot();
    soft.servos.with(*twin::findEffect(id), at(Joint::kShoulderR)).values = values;
    const LimbTrace trace = rollOut(held, 0, arm, soft);
    for (const double position : trace.position_rad.col(0)) EXPECT_NEAR(position, rest, 1e-3) << id;
  }
}

TEST(BodyMechanics, ARobotLikeItsModelHasNoName) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const BodyIdentification answer = identify(movingRobot(shippedRobot(), seed));
    EXPECT_EQ(answer.verdict, Verdict::kCannotTell) << "seed " << seed;
    EXPECT_THAT(answer.mechanics.found, IsEmpty());
    EXPECT_EQ(answer.table.open(), 0u);
  }
}

TEST(BodyMechanics, FrictionOfTheNeckIsNamedWithItsNumberAndNothingElseIs) {
  BodyHypothesis hidden = shippedRobot();
  hidden.servos.with(*twin::findEffect("viscous"), at(Joint::kNeck)).values = {0.04};
  const BodyCase given = movingRobot(hidden);
  const BodyIdentification answer = identify(given);
  // Named or, as no joint is ever limp here, ambiguous with back EMF.
  EXPECT_THAT(answer.verdict, AnyOf(Verdict::kNamed, Verdict::kAmbiguous));
  ASSERT_THAT(answer.mechanics.found, SizeIs(1));
  const FoundMechanics& found = answer.mechanics.found.front();
  EXPECT_EQ(found.placed.effect->id, "viscous");
  EXPECT_THAT(found.placed.joints, testing::ElementsAre(Joint::kNeck));
  EXPECT_NEAR(found.own.front() + found.placed.values[0], 0.04, 0.002);
  EXPECT_LT(answer.held_out.after.joints, 0.85 * answer.held_out.before.joints);
  const auto json = asJson(given, answer);
  EXPECT_EQ(json["effects"][0]["at"], "Neck");
  EXPECT_TRUE(json["remainder"].is_null());
}

TEST(BodyMechanics, AMassInTheHandIsNamedWithItsLink) {
  BodyHypothesis hidden = shippedRobot();
  hidden.links.push_back({.link = Joint::kArmLowerL, .mass_kg = 0.06, .from_com_m = {0, -0.055, 0}});
  const BodyIdentification answer = identify(movingRobot(hidden));
  ASSERT_THAT(answer.mechanics.found, SizeIs(1));
  const FoundMechanics& found = answer.mechanics.found.front();
  EXPECT_EQ(found.placed.effect->id, "link_mass");
  EXPECT_EQ(found.placed.joints.front(), Joint::kArmLowerL);
  EXPECT_NEAR(found.placed.values[0], 0.06, 0.015);
}

TEST(BodyMechanics, AMassInTheHandIsNamedAlsoIfTheNeckNeverAnswers) {
  BodyHypothesis hidden = shippedRobot();
  hidden.links.push_back({.link = Joint::kArmLowerL, .mass_kg = 0.06, .from_com_m = {0, -0.055, 0}});
  BodyCase given = movingRobot(hidden);
  given.is_absent[index(Joint::kNeck)] = true;
  for (std::size_t i = index(Joint::kNeck); i < given.joints.logs.size(); i += kJoints) {
    Trajectory& neck = given.joints.logs[i];
    std::ranges::fill(neck.position_rad, std::nan("")), std::ranges::fill(neck.load, std::nan(""));
    std::ranges::fill(neck.goal_rad, 0), std::ranges::fill(neck.torque_on, 0);
  }
  const BodyIdentification answer = identify(given);
  ASSERT_THAT(answer.mechanics.found, SizeIs(1));
  EXPECT_EQ(answer.mechanics.found.front().placed.effect->id, "link_mass");
  EXPECT_EQ(answer.mechanics.found.front().placed.joints.front(), Joint::kArmLowerL);
  EXPECT_EQ(answer.table.not_tested.front(), absentText(given));
  EXPECT_TRUE(std::isfinite(answer.held_out.after.joints)) << "of the joints that answer";
}

TEST(BodyMechanics, ALegThatStaysOpenHidesNothingElseThatWasNotTested) {
  BodyCase given = movingRobot(shippedRobot());  // clamped logs, without voltages
  for (std::size_t row = 60; row < 90; ++row)
    given.joints.logs[index(Joint::kLegLowerR)].position_rad[row] += 0.03 * std::sin(0.4 * static_cast<double>(row));
  const BodyIdentification answer = identify(given);
  EXPECT_EQ(answer.verdict, Verdict::kUnknown);
  EXPECT_THAT(answer.table.not_tested, Contains(kNoFloorSignals));
  EXPECT_THAT(answer.table.not_tested, Contains(HasSubstr("supply")));
  EXPECT_THAT(answer.table.not_tested, Not(Contains(kLegNotExplained)));
}

TEST(BodyMechanics, APriorOfTheFrictionHidesWhatItAllows) {
  BodyHypothesis hidden = shippedRobot();
  hidden.servos.with(*twin::findEffect("coulomb"), at(Joint::kNeck)).values = {0.033};
  BodyCase given = movingRobot(hidden);
  EXPECT_GT((localize(given, RestingImu{given.joints.model}, ClampedRobot{given}).open()), 0u);
  given.trust["friction"] = 0.2;
  EXPECT_EQ((localize(given, RestingImu{given.joints.model}, ClampedRobot{given}).open()), 0u);
}

TEST(BodyMechanics, AFitOfALimbsNumbersFindsTheOneThatIsOffAndLeavesASmallerGap) {
  BodyHypothesis hidden = shippedRobot();
  hidden.servos.with(*twin::findEffect("coulomb"), at(Joint::kArmUpperR)).values = {0.025 * 2.5};
  BodyCase given = movingRobot(hidden);
  given.trust["friction"] = 0.6;
  const ClampedRobot robot{given};
  const LimbResiduals& before = robot.residuals(robot.limbOf(Joint::kArmUpperR));
  const std::optional<Eigen::VectorXd> numbers = before.betterNumbers(robot.baseline());
  ASSERT_TRUE(numbers);
  const std::vector<BodyNuisance> names = nuisancesOf(given, before.limb());
  const auto friction = std::ranges::find(names, "ArmUpperR coulomb", &BodyNuisance::name) - names.begin();
  ASSERT_LT(friction, numbers->size());
  EXPECT_NEAR((*numbers)[friction], 2.5, 0.6);
  EXPECT_LT(before.about(robot.baseline(), *numbers)->of(robot.baseline()).squaredNorm(),
            before.of(robot.baseline()).squaredNorm());
}

TEST(BodyMechanics, AFrictionBeyondItsPriorIsNamedWithItsNumber) {
  BodyHypothesis hidden = shippedRobot();
  hidden.servos.with(*twin::findEffect("coulomb"), at(Joint::kArmUpperR)).values = {0.125};
  BodyCase given = movingRobot(hidden);
  given.trust["friction"] = 0.2;
  const BodyIdentification answer = identify(given);
  ASSERT_THAT(answer.mechanics.found, SizeIs(1));
  EXPECT_EQ(answer.mechanics.found.front().placed.effect->id, "coulomb");
  EXPECT_NEAR(answer.mechanics.found.front().placed.values[0], 0.1, 0.015) << "beyond the 0.025 of the model";
}

}  // namespace
}  // namespace darwinop::gap
