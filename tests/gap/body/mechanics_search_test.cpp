// How the search for effects of joints and links goes on where one limb, one joint or one name is not explained.
#include <gmock/gmock.h>

#include "core/random.hpp"
#include "gap/body/searched_robot.hpp"
#include "gap/identify/body/controller_selection.hpp"
#include "gap/identify/body/next_mechanics.hpp"
#include "gap/identify/body/unexplained_mechanics.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::SizeIs;

constexpr double kOpenFrom = 3.6;  // sigma: 1 % for 66 rows

/// What no effect does, in every log of one joint: both load and position jump about.
void disturb(BodyCase& given, Joint joint, double by_rad) {
  Rng rng{7};
  for (Trajectory& log : given.joints.logs) {
    if (log.joint != joint) continue;
    for (std::size_t row = 0; row < log.rows(); ++row) {
      const double error = by_rad * rng.normal();
      log.position_rad[row] += error;
      log.load[row] += 2 * error;
    }
  }
}

TEST(MechanicsSearch, ALimbThatNothingExplainsHidesNoEffectOfAnother) {
  BodyCase given = movingRobot(shippedWith("viscous", {Joint::kPelvR}, {0.08}));
  disturb(given, Joint::kArmUpperR, 0.05);
  EXPECT_THAT(namesOf(selectionFor(given).found), Contains(testing::HasSubstr("PelvR")));
}

TEST(MechanicsSearch, AJointWhoseLoadsNothingExplainsHidesNoEffectOfAnothersLoads) {
  BodyCase given = movingRobot(shippedWith("kp_scale", {Joint::kLegUpperR, Joint::kLegUpperL}, {1.1}));
  disturb(given, Joint::kArmUpperR, 0.05);
  EXPECT_THAT(namesOf(identifyControllers(given, shippedRobot(), kOpenFrom)), Contains("kp_scale LegUpperR LegUpperL"));
}

TEST(MechanicsSearch, TheBestCandidatesOfEveryLimbAreFitted) {
  const BodyCase given = movingRobot(shippedRobot());
  const ClampedRobot robot{given};
  std::vector<MechanicsCandidate> candidates;
  for (const MechanicalEffect& effect : mechanicalEffects())
    candidates.push_back({{&effect, {Joint::kArmUpperR}, std::vector<double>(effect.numbers.size(), 0.0)}, 1000});
  candidates.push_back({{&effectCalled("coulomb"), {Joint::kPelvR}, {0.05}}, 30});
  std::vector<std::string> names;
  std::size_t of_link = 0;
  for (const MechanicsCandidate& one : shortlist(robot, candidates)) {
    names.push_back(std::string{one.placed.effect->id} + " " + std::string{row(one.placed.joints.front()).name});
    of_link += one.placed.effect->is_of_link ? 1 : 0;
  }
  EXPECT_THAT(names, Contains("coulomb PelvR"));
  EXPECT_LE(of_link, 1u) << "mass and centre of mass of a link take one place";
}

TEST(MechanicsSearch, NumbersHaveTheirPriceBeforeAFit) {
  const BodyCase given = movingRobot(shippedRobot());
  const ClampedRobot robot{given};
  const auto one = [](std::string_view id, double gain) {
    const MechanicalEffect& effect = effectCalled(id);
    return MechanicsCandidate{{&effect, {Joint::kArmUpperR}, std::vector<double>(effect.numbers.size(), 0.0)}, gain};
  };
  EXPECT_EQ(shortlist(robot, {one("link_mass", 102), one("viscous", 100)}).front().placed.effect->id, "viscous");
}

TEST(MechanicsSearch, ACandidateForAllJointsIsScreenedWhereTheHeadIsClosed) {
  const BodyCase given = movingRobot(shippedWith("viscous", allJoints(), {0.03}));
  const ClampedRobot robot{given};
  const std::size_t head = robot.limbOf(Joint::kNeck);
  std::vector<std::size_t> open;
  for (std::size_t limb = 0; limb < robot.limbs().size(); ++limb)
    if (limb != head) open.push_back(limb);
  const std::vector<MechanicsEntry> entries =
      nextMechanics(robot, {}, open, std::vector<double>(robot.limbs().size(), 0.0));
  ASSERT_FALSE(entries.empty());
  EXPECT_EQ(entries.front().placed().effect->id, "viscous");
  EXPECT_THAT(entries.front().placed().joints, SizeIs(kJoints));
}

TEST(MechanicsSearch, WhereAnEffectOfAllJointsIsRefusedThoseOfOneAreTried) {
  BodyCase given = movingRobot(shippedWith("viscous", allJoints(), {0.03}));
  const BodyCase unseen = movingRobot(shippedWith("viscous", {Joint::kNeck}, {0.03}));
  for (std::size_t i = 0; i < given.joints.logs.size(); ++i)
    if (given.joints.logs[i].held_out) given.joints.logs[i] = unseen.joints.logs[i];
  const MechanicsSelection answer = selectionFor(given);
  EXPECT_THAT(answer.tried.front().joints, SizeIs(kJoints));
  EXPECT_THAT(answer.tried, Contains(testing::Field(&PlacedMechanics::joints, SizeIs(1))));
}

TEST(MechanicsSearch, TheOtherJointOfAPairIsAskedWhereItsLimbIsClosed) {
  const std::vector<Joint> both{Joint::kArmUpperR, Joint::kArmUpperL};
  for (const bool is_pair : {true, false}) {
    const BodyCase given =
        movingRobot(shippedWith("viscous", is_pair ? both : std::vector<Joint>{Joint::kArmUpperR}, {0.05}));
    const ClampedRobot robot{given};
    const std::vector<MechanicsEntry> entries =
        nextMechanics(robot, {}, {robot.limbOf(Joint::kArmUpperR)}, std::vector<double>(robot.limbs().size(), 1e9));
    ASSERT_FALSE(entries.empty());
    EXPECT_EQ(entries.front().placed().effect->id, "viscous");
    EXPECT_THAT(entries.front().placed().joints, SizeIs(is_pair ? 2 : 1));
  }
}

TEST(MechanicsSearch, ASmallRemainderTakesNoNameAwayThatHeldOutRecordingsShow) {
  const BodyCase given = movingRobot(shippedWith("viscous", {Joint::kArmUpperR}, {0.03}));
  for (const Joint joint : {Joint::kArmUpperR, Joint::kArmLowerR}) {
    const ClampedRobot robot{given};
    MechanicsSelection selection;
    selection.found.push_back({.placed = {&effectCalled("viscous"), {joint}, {0.03}}, .sigmas = {}, .rivals = {}});
    selection.rows = mechanicsRows(robot, robot.baseline());
    for (BodyRow& row : selection.rows) row.significance = 2 * kOpenFrom;
    dropUnexplained(robot, kOpenFrom, selection);
    EXPECT_THAT(selection.found, SizeIs(joint == Joint::kArmUpperR ? 1 : 0)) << row(joint).name;
  }
}

// White noise on all positions leaves a large remainder under any model.
TEST(MechanicsSearch, WhatSeveralLimbsShowInHeldOutRecordingsKeepsItsName) {
  BodyCase given = movingRobot(shippedWith("viscous", allJoints(), {0.06}));
  Rng rng{7};
  for (Trajectory& log : given.joints.logs)
    for (double& position : log.position_rad) position += 0.0009 * rng.normal();
  for (const bool is_everywhere : {true, false}) {
    const std::vector<Joint> joints = is_everywhere ? allJoints() : std::vector<Joint>{Joint::kArmUpperR};
    const ClampedRobot robot{given};
    MechanicsSelection selection;
    selection.found.push_back({.placed = {&effectCalled("viscous"), joints, {0.06}}, .sigmas = {}, .rivals = {}});
    selection.rows = mechanicsRows(robot, robot.baseline());
    for (BodyRow& row : selection.rows) row.significance = 2 * kOpenFrom;
    dropUnexplained(robot, kOpenFrom, selection);
    EXPECT_THAT(selection.found, SizeIs(is_everywhere ? 1 : 0)) << joints.size() << " joints";
  }
}

}  // namespace
}  // namespace darwinop::gap
