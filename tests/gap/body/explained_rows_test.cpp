// Which open rows of the table a found name explains.
#include <gmock/gmock.h>

#include "gap/identify/body/body_identification.hpp"

namespace darwinop::gap {
namespace {

TEST(ExplainedRows, AFrictionInAnArmDoesNotExplainTheSupplyOrTheLoadOfALeg) {
  const auto rowOf = [](std::string_view joint, Block block, bool is_open) {
    BodyRow row;
    row.signal = std::string{joint} + (block == Block::kSupply ? ".voltage" : ".load");
    row.place = {.kind = Place::Kind::kJoint, .name = std::string{joint}};
    row.block = block, row.open = is_open;
    return row;
  };
  BodyIdentification answer;
  answer.table.rows = {rowOf("FootL", Block::kSupply, true), rowOf("FootL", Block::kController, true),
                       rowOf("ArmLowerR", Block::kController, true), rowOf("ArmLowerR", Block::kSupply, true)};
  answer.mechanics.rows = {rowOf("FootL", Block::kPlant, false), rowOf("ArmLowerR", Block::kPlant, false)};
  const auto coulomb = std::ranges::find(mechanicalEffects(), "coulomb", &MechanicalEffect::id);
  answer.mechanics.found = {{.placed = {&*coulomb, {Joint::kArmLowerR}, {0.1}}, .sigmas = {}, .rivals = {}}};
  answer.mechanics.touched = {Joint::kShoulderR, Joint::kArmUpperR, Joint::kArmLowerR};
  const std::string text = asText(answer);
  for (const char* const left : {"FootL.voltage, supply", "FootL.load, controller", "ArmLowerR.voltage, supply"})
    EXPECT_THAT(text, testing::HasSubstr(kNotExplained + std::string{left}));
  EXPECT_THAT(text, testing::Not(testing::HasSubstr(kNotExplained + std::string{"ArmLowerR.load"})));
}

}  // namespace
}  // namespace darwinop::gap
