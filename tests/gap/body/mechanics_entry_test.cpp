// Which names beside the best one recordings of limbs do not exclude.
#include "gap/identify/body/mechanics_entry.hpp"

#include <gmock/gmock.h>

#include <algorithm>

namespace darwinop::gap {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

MechanicsEntry entryOf(std::string_view id, Joint joint, double gain, double evidence) {
  const MechanicalEffect& effect = *std::ranges::find(mechanicalEffects(), id, &MechanicalEffect::id);
  MechanicsEntry out{.fit = {}, .evidence = evidence, .gain = gain};
  out.fit.effects.push_back({&effect, {joint}, std::vector<double>(effect.numbers.size(), 0.0)});
  return out;
}

std::vector<std::string_view> rivalIds(const std::vector<MechanicsEntry>& entries) {
  std::vector<std::string_view> out;
  for (const PlacedMechanics& one : rivalsOf(entries)) out.push_back(one.effect->id);
  return out;
}

TEST(MechanicsEntry, MassAndCentreOfMassOfALinkAreRivalsWhereTheyExplainAsMuch) {
  EXPECT_THAT(rivalIds({entryOf("link_com", Joint::kHead, 200, 170), entryOf("link_mass", Joint::kHead, 198, 158)}),
              ElementsAre("link_mass"))
      << "12 of the evidence are the price of one more number, which its prior determines";
}

TEST(MechanicsEntry, AMassThatShowsByItselfIsDecided) {
  EXPECT_THAT(rivalIds({entryOf("link_mass", Joint::kHead, 240, 200), entryOf("link_com", Joint::kHead, 200, 170)}),
              IsEmpty());
}

TEST(MechanicsEntry, AMassOfAnotherLinkPaysForItsNumbers) {
  EXPECT_THAT(rivalIds({entryOf("link_com", Joint::kHead, 200, 170), entryOf("link_mass", Joint::kNeck, 198, 158)}),
              IsEmpty());
}

TEST(MechanicsEntry, AnAnswerAboutALinkHasAtMostThreeNamesAndBothOfTheLink) {
  EXPECT_THAT(rivalIds({entryOf("link_com", Joint::kHead, 200, 170), entryOf("viscous", Joint::kHead, 195, 168),
                        entryOf("coulomb", Joint::kHead, 195, 167), entryOf("link_mass", Joint::kHead, 198, 158)}),
              ElementsAre("link_mass", "viscous"));
}

}  // namespace
}  // namespace darwinop::gap
