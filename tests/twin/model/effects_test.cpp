// All effects of the catalogue in model files, for all joints and for one.
#include <gmock/gmock.h>

#include "twin/effects/catalogue.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/messages.hpp"
#include "twin/model/texts.hpp"

namespace darwinop::twin {
namespace {

class EveryEffect : public testing::TestWithParam<const EffectInfo*> {
 protected:
  static EffectSetting setting(double Parameter::*value, std::optional<Joint> joint = {}) {
    EffectSetting effect{GetParam(), {}, joint};
    for (const Parameter& parameter : GetParam()->parameters) effect.values.push_back(parameter.*value);
    return effect;
  }

  /// A model with only this effect, written and read back.
  static std::vector<EffectSetting> afterAFile(const EffectSetting& effect) {
    Model model;
    model.name = "test";
    model.effects = {effect};
    return parseModel(writeModel(model), "my.ini").effects;
  }

  static void expectSame(const std::vector<EffectSetting>& read, const EffectSetting& written) {
    ASSERT_EQ(read.size(), 1U);
    EXPECT_EQ(read[0].info, written.info);
    EXPECT_EQ(read[0].values, written.values);
    EXPECT_EQ(read[0].joint, written.joint);
  }
};

TEST_P(EveryEffect, IsSwitchedOnAloneAndReadBackWithoutLoss) {
  for (double Parameter::*value : {&Parameter::typical, &Parameter::neutral, &Parameter::low, &Parameter::high}) {
    const EffectSetting all = setting(value), one = setting(value, Joint::kAnkleL);
    expectSame(afterAFile(all), all);
    expectSame(afterAFile(one), one);
  }
}

TEST_P(EveryEffect, IsInTheServosOfItsJoints) {
  Model model;
  model.effects = {setting(&Parameter::typical, Joint::kAnkleL)};
  EXPECT_TRUE(effectsOf(model, Joint::kAnkleR).empty());
  const auto effects = effectsOf(model, Joint::kAnkleL);
  ASSERT_EQ(effects.size(), 1U);
  EXPECT_EQ(&effects[0]->info(), GetParam());
}

TEST_P(EveryEffect, IsAddedToAModelFileAndRemovedAgain) {
  const EffectSetting effect = setting(&Parameter::typical, Joint::kNeck);
  const std::string with = withEffect(kNamed, effect, {"found on Monday"});
  expectSame(parseModel(with, "my.ini").effects, effect);
  EXPECT_EQ(withoutEffect(with, GetParam()->id, Joint::kNeck), kNamed);
}

TEST_P(EveryEffect, NeedsAllItsParameters) {
  const std::string header = "[effect " + std::string{GetParam()->id} + "]\n";
  for (const Parameter& left_out : GetParam()->parameters) {
    std::string lines = header;
    for (const Parameter& parameter : GetParam()->parameters)
      if (&parameter != &left_out)
        lines += std::string{parameter.key} + " = " + writeNumber(parameter.typical, ruleOf(parameter)) + "\n";
    EXPECT_EQ(refusalOf(lines), "my.ini, line 3: [effect " + std::string{GetParam()->id} + "] " +
                                    std::string{left_out.key} + messages::kMissing + allowed(ruleOf(left_out)));
  }
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryEffect, testing::ValuesIn(catalogue().begin(), catalogue().end()),
                         [](const auto& effect) { return std::string{effect.param->id}; });

const std::string kCommonAndOwn =
    "[effect coulomb Neck]\nfriction = 0.05 N m\n[effect viscous]\ndamping = 0.01 N m s/rad\n"
    "[effect coulomb]\nfriction = 0.02 N m\n";

double frictionOf(Joint joint) {
  Signals s;
  for (const auto& effect : effectsOf(modelOf(kCommonAndOwn), joint)) effect->mechanics(s);
  return s.dry_friction_nm;
}

TEST(EffectsOfAJoint, ItsOwnSettingOverridesTheCommonOneInAnyOrder) {
  EXPECT_EQ(frictionOf(Joint::kNeck), 0.05);
  EXPECT_EQ(frictionOf(Joint::kHead), 0.02);
}

TEST(EffectsOfAJoint, AreInCatalogueOrder) {
  const auto effects = effectsOf(modelOf("[effect viscous]\ndamping = 0.01 N m s/rad\n"
                                         "[effect coulomb]\nfriction = 0.02 N m\n"
                                         "[effect speed_limit]\nspeed = 2 rad/s\n"),
                                 Joint::kHead);
  std::vector<std::string_view> ids;
  for (const auto& effect : effects) ids.push_back(effect->info().id);
  EXPECT_THAT(ids, testing::ElementsAre("speed_limit", "coulomb", "viscous"));
}

}  // namespace
}  // namespace darwinop::twin
