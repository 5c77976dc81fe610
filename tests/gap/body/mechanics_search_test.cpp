// How the search for effects of joints and links goes on where one limb, one joint or one name is not explained.
#include <gmock/gmock.h>

#include <algorithm>

#include "core/random.hpp"
#include "gap/body/moving_robot.hpp"
#include "gap/identify/body/controller_selection.hpp"
#include "gap/identify/body/held_out_motion.hpp"
#include "gap/identify/body/next_mechanics.hpp"
#include "gap/identify/body/unexplained_mechanics.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::SizeIs;

constexpr double kOpenFrom = 3.6;  // sigma: 1 % for 66 rows

const MechanicalEffect& effectCalled(std::string_view id) {
  return *std::ranges::find(mechanicalEffects(), id, &MechanicalEffect::id);
}

BodyHypothesis shippedWith(std::string_view id, const std::vector<Joint>& joints, const std::vector<double>& values) {
  BodyHypothesis robot = shippedRobot();
  for (const Joint joint : joints) effectCalled(id).apply(robot, joint, values);
  return robot;
}

std::vector<Joint> allJoints() {
  std::vector<Joint> all;
  for (std::size_t joint = 0; joint < kJoints; ++joint) all.push_back(static_cast<Joint>(joint));
  return all;
}

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

MechanicsSelection selectionFor(const BodyCase& given) {
  ClampedRobot robot{given};
  return identifyMechanics(robot, localize(given, RestingImu{given.joints.model}, robot));
}

std::vector<std::string> namesOf(const std::vector<FoundMechanics>& found) {
  std::vector<std::string> out;
  for (const FoundMechanics& one : found) {
    out.emplace_back(one.placed.effect->id);
    for (const Joint joint : one.placed.joints) out.back() += " " + std::string{row(joint).name};
  }
  return out;
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

TEST(MechanicsSearch, HeldOutRecordingsAreJudgedWithTheNumbersThatWereFitted) {
  BodyCase given = movingRobot(shippedWith("coulomb", {Joint::kArmUpperR}, {0.04}));
  given.trust["friction"] = 0.6;
  ClampedRobot robot{given};
  const double declared = heldOutError(robot, robot.baseline());
  const std::size_t limb = robot.limbOf(Joint::kArmUpperR);
  const auto numbers = robot.residuals(limb).betterNumbers(robot.baseline());
  ASSERT_TRUE(numbers);
  robot.replace(limb, robot.residuals(limb).about(robot.baseline(), *numbers));
  EXPECT_LT(heldOutError(robot, robot.baseline()), 0.9 * declared);
}

TEST(MechanicsSearch, ASimulationOfHeldOutRecordingsThatFailsContradicts) {
  const double none = std::nan("");
  EXPECT_TRUE(holdsUnseen(0.001, 0.00102));
  EXPECT_FALSE(holdsUnseen(0.001, 0.0011));
  EXPECT_FALSE(holdsUnseen(0.001, none));
  EXPECT_TRUE(holdsUnseen(none, none)) << "there are none";
}

TEST(MechanicsSearch, AFrictionIsFoundAsAnAdditionToEachJointsOwn) {
  const MechanicsSelection all = selectionFor(movingRobot(shippedWith("coulomb", allJoints(), {0.05})));
  ASSERT_THAT(all.found, SizeIs(1));
  EXPECT_EQ(all.found.front().placed.effect->id, "coulomb");
  EXPECT_THAT(all.found.front().placed.joints, SizeIs(kJoints));
  EXPECT_NEAR(all.found.front().placed.values[0], 0.05, 0.005);
}

TEST(MechanicsSearch, ASecondAdditionToAJointIsOnTopOfTheFirst) {
  const MechanicalEffect& coulomb = effectCalled("coulomb");
  std::vector<FoundMechanics> found{
      {.placed = {&coulomb, {Joint::kArmUpperR, Joint::kArmUpperL}, {0.1}}, .sigmas = {}, .rivals = {}},
      {.placed = {&coulomb, {Joint::kArmUpperR}, {0.05}}, .sigmas = {}, .rivals = {}}};
  const double own = ownNumber(shippedRobot(), coulomb, Joint::kArmUpperR);
  setOwn(shippedRobot(), found);
  EXPECT_THAT(found[0].own, ElementsAre(own, own));
  EXPECT_THAT(found[1].own, ElementsAre(own + 0.1));
}

TEST(MechanicsSearch, NoMoreFrictionIsTakenAwayThanThereIs) {
  const MechanicalEffect& coulomb = effectCalled("coulomb");
  const double own = ownNumber(shippedRobot(), coulomb, Joint::kArmUpperR);
  std::vector<FoundMechanics> found{{.placed = {&coulomb, {Joint::kArmUpperR}, {-2 * own}}, .sigmas = {}, .rivals = {}}};
  setOwn(shippedRobot(), found);
  EXPECT_EQ(found.front().placed.values.front(), -own);
}

TEST(MechanicsSearch, AFrictionOfAnAnkleIsFoundBeyondTheLargestOfASingleServo) {
  const MechanicsSelection answer = selectionFor(movingRobot(shippedWith("coulomb", {Joint::kAnkleR}, {0.1})));
  ASSERT_THAT(answer.found, SizeIs(1));
  EXPECT_EQ(namesOf(answer.found).front(), "coulomb AnkleR");
  EXPECT_NEAR(answer.found.front().placed.values[0], 0.1, 0.01);
  EXPECT_THAT(answer.found.front().own, ElementsAre(0.25));
}

class Ripple : public testing::TestWithParam<std::vector<double>> {};
INSTANTIATE_TEST_SUITE_P(Hidden, Ripple,
                         testing::Values(std::vector<double>{0.04, 45, 1.57}, std::vector<double>{0.04, 13, -2.6},
                                         std::vector<double>{0.04, 24, 0}));

TEST_P(Ripple, IsFoundWithItsCountAndPhase) {
  const std::vector<double>& hidden = GetParam();
  const MechanicsSelection answer = selectionFor(movingRobot(shippedWith("cogging", {Joint::kLegUpperR}, hidden)));
  ASSERT_THAT(answer.found, SizeIs(1));
  EXPECT_EQ(namesOf(answer.found).front(), "cogging LegUpperR");
  const std::vector<double>& found = answer.found.front().placed.values;
  EXPECT_NEAR(found[0], hidden[0], 0.1 * hidden[0]);
  EXPECT_NEAR(found[1], hidden[1], 1);
  const auto& limits = kJointTable[static_cast<std::size_t>(Joint::kLegUpperR)];
  const double middle = radFromTicks(static_cast<std::uint16_t>((limits.low + limits.high) / 2)).value;
  const auto at_middle = [&](const std::vector<double>& ripple) { return ripple[1] * middle + ripple[2]; };
  EXPECT_NEAR(std::remainder(at_middle(found) - at_middle(hidden), 2 * kPi), 0, 0.3) << "count and phase go together";
}

}  // namespace
}  // namespace darwinop::gap
