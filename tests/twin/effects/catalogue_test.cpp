// Consistency of the effect catalogue.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <set>

#include "twin/effects/rig.hpp"

namespace darwinop::twin {
namespace {

class EffectRow : public testing::TestWithParam<const EffectInfo*> {};

bool isIdentifier(std::string_view text) {
  const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
         std::ranges::all_of(text, allowed);
}

/// "N m s/rad", "kg m2", "1/(N m)": known names with an exponent, between blanks, a slash and brackets.
bool isUnit(std::string_view text) {
  static const std::set<std::string> kNames{"N", "m", "s", "rad", "V", "A", "ohm", "K", "degC", "kg"};
  std::string name;
  bool good = true;
  const auto close = [&] {
    while (!name.empty() && (name.back() == '2' || name.back() == '3')) name.pop_back();
    good = good && (name.empty() || name == "1" || kNames.contains(name));
    name.clear();
  };
  for (const char c : text) {
    if (c == ' ' || c == '/' || c == '(' || c == ')')
      close();
    else
      name += c;
  }
  close();
  return good;
}

bool isSentence(std::string_view text, std::size_t most) {
  return !text.empty() && text.size() <= most && text.find('\n') == text.npos && text.find("  ") == text.npos &&
         text.front() != ' ' && text.back() != ' ';
}

TEST_P(EffectRow, HasKeysUnitsAndTexts) {
  const EffectInfo& info = *GetParam();
  EXPECT_TRUE(isIdentifier(info.id));
  EXPECT_TRUE(isSentence(info.title, 60)) << info.title;
  EXPECT_TRUE(isSentence(info.equation, 160)) << info.equation;
  for (const std::string_view text : {info.signature, info.separated_by, info.source})
    EXPECT_TRUE(isSentence(text, 260)) << text;
  EXPECT_FALSE(name(info.part).empty());
  EXPECT_FALSE(info.parameters.empty()) << "an effect needs a parameter to be fitted";

  std::set<std::string_view> keys;
  for (const Parameter& parameter : info.parameters) {
    SCOPED_TRACE(parameter.key);
    EXPECT_TRUE(isIdentifier(parameter.key));
    EXPECT_TRUE(keys.insert(parameter.key).second) << "duplicate key";
    EXPECT_TRUE(isUnit(parameter.unit)) << "unit " << parameter.unit << " is not composed of the SI units of this test";
    EXPECT_TRUE(isSentence(parameter.meaning, 100)) << parameter.meaning;
    EXPECT_TRUE(parameter.secondary || info.equation.find(parameter.key) != std::string_view::npos)
        << "missing in the equation " << info.equation;
  }
}

TEST_P(EffectRow, HasNumbersThatAModelFileMayHold) {
  for (const Parameter& parameter : GetParam()->parameters) {
    SCOPED_TRACE(parameter.key);
    EXPECT_TRUE(std::isfinite(parameter.low) && std::isfinite(parameter.high));
    EXPECT_LT(parameter.low, parameter.high);
    for (const double value : {parameter.neutral, parameter.typical}) {
      EXPECT_GE(value, parameter.low);
      EXPECT_LE(value, parameter.high);
    }
    EXPECT_TRUE(!parameter.logarithmic || parameter.low >= 0) << "a logarithm of a negative number";
  }
}

TEST_P(EffectRow, ListsOnlyKnownEffectsAsConfounded) {
  const EffectInfo& info = *GetParam();
  EXPECT_FALSE(info.confused_with.empty()) << "every effect is confounded with at least one other";
  const std::set<std::string_view> unique(info.confused_with.begin(), info.confused_with.end());
  EXPECT_EQ(unique.size(), info.confused_with.size()) << "duplicate name";
  EXPECT_FALSE(unique.contains(info.id)) << "confounded with itself";
  for (const std::string_view id : info.confused_with) EXPECT_NE(findEffect(id), nullptr) << id << " does not exist";
}

TEST_P(EffectRow, HasASymmetricConfoundedRelation) {
  for (const EffectInfo* other : doublesOf(*GetParam())) {
    const auto back = doublesOf(*other);
    EXPECT_NE(std::ranges::find(back, GetParam()), back.end()) << other->id;
  }
}

TEST_P(EffectRow, CreatesTheEffectThatItDescribes) {
  const EffectInfo& info = *GetParam();
  const auto effect = info.make(valuesOf(info, &Parameter::typical));
  ASSERT_NE(effect, nullptr);
  EXPECT_EQ(&effect->info(), &info);
  EXPECT_NE(effect->hooks(), 0) << "the effect has no hooks";
  EXPECT_EQ(findEffect(info.id), &info);
}

TEST_P(EffectRow, HasFacetsThatFitItsParameters) {
  const EffectInfo& info = *GetParam();
  const auto count = info.parameters.size();
  for (const BaselineAlias& alias : info.aliases) {
    EXPECT_LT(alias.parameter, count) << alias.number;
    if (alias.relation != BaselineAlias::Relation::kOwnValue) continue;
    EXPECT_EQ(alias.number, std::string{info.id} + "." + std::string{info.parameters[0].key});
    EXPECT_FALSE(alias.case_key.empty());
  }
  for (const DrawnParameter& drawn : info.synthetic.drawn) {
    ASSERT_LT(drawn.parameter, count);
    EXPECT_GE(drawn.low, info.parameters[drawn.parameter].low);
    EXPECT_LE(drawn.high, info.parameters[drawn.parameter].high);
  }
  for (const OtherName& other : info.other_names)
    EXPECT_TRUE(std::ranges::find(info.parameters, other.key, &Parameter::key) != info.parameters.end()) << other.key;
  for (const Holding& one : {info.exports.webots, info.exports.mujoco, info.exports.urdf})
    EXPECT_GT(one.how.size(), 5u);
  EXPECT_EQ(info.laws == Laws::kReplacesSpeedP, info.synthetic.growth == Synthetic::Growth::kSwitch);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EffectRow, testing::ValuesIn(catalogue().begin(), catalogue().end()),
                         [](const auto& row) { return std::string{row.param->id}; });

// Of two parameters with one role only the first would be read.
TEST(Catalogue, HasEveryIdRoleAndRankOnce) {
  std::set<std::string_view> ids;
  std::multiset<ParameterRole> roles;
  std::multiset<int> ranks;
  for (const EffectInfo* info : catalogue()) {
    ranks.insert(info->synthetic.pair_rank);
    for (const Parameter& parameter : info->parameters) roles.insert(parameter.role);
  }
  for (const ParameterRole role : roles)
    EXPECT_TRUE(role == ParameterRole::kNone || roles.count(role) == 1) << static_cast<int>(role);
  for (const int rank : ranks) EXPECT_TRUE(rank == 0 || ranks.count(rank) == 1) << rank;
  for (const EffectInfo* info : catalogue()) EXPECT_TRUE(ids.insert(info->id).second) << "duplicate id " << info->id;
  EXPECT_EQ(findEffect("no_such_effect"), nullptr);
}

// Existing model files and fit results contain these ids.
TEST(Catalogue, KeepsTheIdsOfExistingFiles) {
  for (const std::string_view id : {"accel_limit",      "speed_limit",  "torque_limit",    "coulomb",
                                    "viscous",          "stribeck",     "backlash",        "load_dependent_friction",
                                    "supply_sag",       "deadband",     "kt_error",        "directional_load_friction",
                                    "resistance_error", "lost_packets", "transport_delay", "quadratic_load_friction",
                                    "encoder_offset",   "gear_scale",   "p_on_torque",     "encoder_quantisation",
                                    "kp_scale",         "integral",     "derivative",      "com_mass",
                                    "inertia",          "joint_flex",   "temp_drift",      "cogging"})
    EXPECT_NE(findEffect(id), nullptr) << id;
}

// temp_drift scales the friction accumulated before it.
TEST(Catalogue, HasEveryFrictionBeforeTempDrift) {
  const auto table = catalogue();
  const auto drift = std::ranges::find(table, "temp_drift", &EffectInfo::id);
  for (auto row = drift + 1; row != table.end(); ++row)
    EXPECT_NE((*row)->part, LoopPart::kFriction) << (*row)->id << ": move its row before temp_drift's";
}

TEST(ConfoundedEffects, AreFoundFromBothSides) {
  const EffectInfo& coulomb = *findEffect("coulomb");
  const auto& listed = coulomb.confused_with;
  ASSERT_EQ(std::ranges::find(listed, "temp_drift"), listed.end()) << "choose another pair that only one side lists";
  const auto doubles = doublesOf(coulomb);
  EXPECT_NE(std::ranges::find(doubles, findEffect("temp_drift")), doubles.end());
}

}  // namespace
}  // namespace darwinop::twin
