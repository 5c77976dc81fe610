// Names of trunk and floor beside limbs that are not explained.
#include <gmock/gmock.h>

#include "gap/identify/body/floor_candidates.hpp"
#include "gap/identify/body/floor_selection.hpp"
#include "gap/plant/body/joint_alone.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using testing::UnorderedElementsAre;

std::vector<std::string> refusedBeside(const std::vector<Joint>& unexplained) {
  std::vector<std::string> out;
  for (const FloorEffect& effect : floorEffects(twin::readModel(twin::findModel("darwin-op"))))
    if (isOfLimb(effect, unexplained)) out.push_back(std::string{effect.id} + "@" + std::string{effect.at});
  return out;
}

TEST(FloorNames, AMassThatMovesInALimbIsNotNamedAsOneOfTheTrunkNorAsATilt) {
  EXPECT_THAT(refusedBeside({Joint::kArmLowerR}),
              UnorderedElementsAre("link_mass@Body", "link_com@Body", "floor_tilt@floor"));
}

TEST(FloorNames, WhereLimbsAreExplainedEveryNameMayBeGiven) {
  EXPECT_THAT(refusedBeside({}), testing::IsEmpty());
}

TEST(FloorNames, AnEncoderOffsetBeginsAtThatOfTheModelAndThatOfClampedLogsStays) {
  BodyCase given;
  given.joints.model = twin::readModel(twin::findModel("darwin-op"));
  const twin::EffectInfo& offset = *twin::findEffect("encoder_offset");
  given.joints.model.effects.push_back({.info = &offset, .values = {0.02}, .joint = Joint::kAnkleR});
  FloorModel about{.robot = {.robot = {bodyBaselineOf(given), {}}, .floor = {}}};
  about.robot.robot.servos.with(offset, {.kind = Place::Kind::kJoint, .name = "FootL"}).values = {0.01};
  std::vector<std::string> places;
  const auto candidates = floorCandidates(given, about);
  for (const FloorEffect& effect : *candidates) {
    if (effect.id != "encoder_offset") continue;
    places.emplace_back(effect.at);
    const double own = effect.at == "AnkleR" ? 0.02 : 0;
    EXPECT_EQ(effect.neutral.front(), own) << effect.at;
    EXPECT_EQ(effect.starts.front().front(), own + offset.parameters.front().typical / 2) << effect.at;
  }
  EXPECT_THAT(places, UnorderedElementsAre("AnkleR", "AnkleL", "FootR"));
}

}  // namespace
}  // namespace darwinop::gap
