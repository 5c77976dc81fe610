// Joint refit and backward elimination of effects.
#include "gap/identify/body/refit_mechanics.hpp"

#include <gmock/gmock.h>

#include "gap/body/searched_robot.hpp"

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<Joint> kPair{Joint::kLegUpperR, Joint::kLegUpperL};

FoundMechanics foundIn(std::string_view id, const std::vector<Joint>& joints, double value) {
  const MechanicalEffect& effect = effectCalled(id);
  PlacedMechanics placed{&effect, joints, {}};
  for (const MechanicalEffect::Number& number : effect.numbers) placed.values.push_back(number.typical);
  placed.values.front() = value;
  return {.placed = placed, .sigmas = {}, .rivals = {}};
}

TEST(RefitMechanics, PlayIsFittedPastTheNextValley) {
  const BodyCase given = movingRobot(shippedWith("backlash", allJoints(), {0.0064}));
  ClampedRobot robot{given};
  std::vector<FoundMechanics> found{foundIn("backlash", allJoints(), 0.0042)};
  refitMechanics(robot, found);
  EXPECT_NEAR(found.front().placed.values.front(), 0.0064, 0.001);
}

TEST(RefitMechanics, ANameThatOnlyStoodInForAnotherIsTakenAway) {
  const BodyCase given = movingRobot(shippedWith("transport_delay", kPair, {0.0153}));
  ClampedRobot robot{given};
  std::vector<FoundMechanics> found{foundIn("derivative", kPair, 0.004), foundIn("transport_delay", kPair, 0.0153)};
  found[0].excess_before = 1000, found[1].excess_before = 40;
  found[1].rivals.push_back(found[0].placed);
  EXPECT_FALSE(dropSuperfluous(robot, found).empty());
  ASSERT_THAT(namesOf(found), ElementsAre("transport_delay LegUpperR LegUpperL"));
  EXPECT_EQ(found[0].excess_before, 1000) << "of which it is judged to explain the most";
  EXPECT_THAT(found[0].rivals, IsEmpty());
}

TEST(RefitMechanics, AnEffectThatTheOthersDoWithoutIsTakenAway) {
  const BodyCase given = movingRobot(shippedWith("viscous", {Joint::kArmUpperR}, {0.05}));
  ClampedRobot robot{given};
  std::vector<FoundMechanics> found{foundIn("coulomb", {Joint::kArmUpperR}, 0.001),
                                    foundIn("viscous", {Joint::kArmUpperR}, 0.049)};
  dropSuperfluous(robot, found);
  EXPECT_THAT(namesOf(found), ElementsAre("viscous ArmUpperR"));
  EXPECT_NEAR(found.front().placed.values.front(), 0.05, 0.005) << "fitted without it";
}

TEST(RefitMechanics, TwoThatAreThereStay) {
  BodyHypothesis hidden = shippedWith("viscous", {Joint::kArmUpperR}, {0.05});
  effectCalled("kp_scale").apply(hidden, Joint::kArmUpperR, {1.1});
  const BodyCase given = movingRobot(hidden);
  ClampedRobot robot{given};
  std::vector<FoundMechanics> found{foundIn("kp_scale", {Joint::kArmUpperR}, 1.1),
                                    foundIn("viscous", {Joint::kArmUpperR}, 0.05)};
  EXPECT_THAT(dropSuperfluous(robot, found), IsEmpty());
  EXPECT_THAT(namesOf(found), ElementsAre("kp_scale ArmUpperR", "viscous ArmUpperR"));
}

}  // namespace
}  // namespace darwinop::gap
