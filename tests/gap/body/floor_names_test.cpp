// Names of trunk and floor beside limbs that are not explained.
#include <gmock/gmock.h>

#include "gap/identify/body/floor_selection.hpp"

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

}  // namespace
}  // namespace darwinop::gap
