// The export reports what a target cannot represent, for every effect.
#include "gap/export/holds.hpp"

#include <gmock/gmock.h>

#include <iterator>

#include "gap/export/export_rig.hpp"

namespace darwinop::gap {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(ExportHolds, EveryEffectOfTheCatalogueHasARowForEveryTarget) {
  const auto catalogue = twin::catalogue();
  const auto rows = effectHoldings();
  ASSERT_EQ(rows.size(), catalogue.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].what, catalogue[i]->id);
    for (const TargetInfo& info : kTargetTable)
      EXPECT_GT(rows[i].of(info.target).how.size(), 5u) << rows[i].what << " for " << info.title;
  }
}

// What the table calls held must move with the effect in the numbers that are written, and what it calls lost must not.
TEST(ExportHolds, TheTableAgreesWithTheTexts) {
  const ExportSettings settings = forArm();
  for (const twin::EffectInfo* info : twin::catalogue()) {
    Believed neutral, typical;
    if (info->id == "p_on_torque") continue;  // swaps all numbers: AModelWhosePIsSwappedIsOneOfThatLaw
    if (info->id == "temp_drift") {
      neutral.friction();
      typical.friction();
    }
    for (const twin::Parameter& parameter : info->parameters) {
      neutral.with(info->id, parameter.key, parameter.neutral);
      typical.with(info->id, parameter.key, parameter.typical);
    }
    if (info->id == "torque_limit") typical.with(info->id, "torque", 1.0);
    if (info->id == "temp_drift") typical.with(info->id, "reference", 45);
    for (const TargetInfo& target : kTargetTable) {
      const std::string before = exportTo(target.target, neutral.get(), settings).text;
      const std::string after = exportTo(target.target, typical.get(), settings).text;
      const auto numbers = [](std::string text) {  // without comments, which name the effect
        for (auto at = text.find("<!--"); at != text.npos; at = text.find("<!--"))
          text.erase(at, text.find("-->", at) + 3 - at);
        for (auto at = text.find('#'); at != text.npos; at = text.find('#')) text.erase(at, text.find('\n', at) - at);
        std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
        return text;
      };
      const Fate fate = holdingOf(*info).of(target.target).fate;
      EXPECT_EQ(numbers(before) == numbers(after), fate == Fate::kLost) << info->id << " for " << target.title;
    }
  }
}

TEST(ExportHolds, LossesAreSentencesWithTheNumbers) {
  Believed model;
  model.friction().with("stribeck", "friction", 0.05).with("supply_sag", "resistance", 0.7);
  for (const TargetInfo& info : kTargetTable) {
    const Export out = exportTo(info.target, model.get(), forArm());
    EXPECT_THAT(out.lost, Contains(HasSubstr("loses stribeck (friction = 0.05 N m")));
    EXPECT_THAT(out.lost, Contains(HasSubstr("supply_sag (resistance = 0.7 ohm")));
    for (const std::string& sentence : out.lost) {
      EXPECT_THAT(sentence, testing::StartsWith(std::string{info.title} + " loses "));
      EXPECT_THAT(out.text, HasSubstr(sentence));  // the file says it too
    }
  }
  EXPECT_THAT(exportTo(Target::kWebots, model.get(), forArm()).lost, Contains(HasSubstr(kPOnTorque)));
  EXPECT_THAT(exportTo(Target::kMujoco, model.get(), forArm()).lost, Not(Contains(HasSubstr(kPOnTorque))));
}

TEST(ExportHolds, AModelWhosePIsSwappedIsOneOfThatLaw) {
  Believed swapped;
  swapped.bySpeed().with("p_on_torque", "on", 1);
  EXPECT_EQ(numbersOf(swapped.get(), {}).stiffness_nm_rad, numbersOf(Believed{}.get(), {}).stiffness_nm_rad);
  EXPECT_TRUE(numbersOf(swapped.get(), {}).p_on_torque);
  EXPECT_THAT(exportTo(Target::kWebots, swapped.get(), forArm()).lost,
              Contains(HasSubstr("loses p_on_torque (on = 1)")));
  EXPECT_THAT(exportTo(Target::kMujoco, swapped.get(), forArm()).lost, Not(Contains(HasSubstr("P on"))));
}

TEST(ExportHolds, AnEffectAtItsNeutralValuesIsNotReported) {
  Believed model;
  model.with("stribeck", "friction", 0);
  EXPECT_THAT(exportTo(Target::kUrdf, model.get(), forArm()).lost, Not(Contains(HasSubstr("stribeck"))));
}

}  // namespace
}  // namespace darwinop::gap
