#include "gap/plant/baseline_alias.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "gap/plant/baseline_number.hpp"

namespace darwinop::gap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Factor by which `hypothesis` changes the number of the alias. Nothing: the baseline does not have it.
std::optional<double> changeOf(const twin::BaselineAlias& alias, const twin::EffectInfo& effect,
                               const Hypothesis& baseline, const Hypothesis& hypothesis) {
  const double value = hypothesis.find(effect.id)->values[alias.parameter];
  if (alias.relation == twin::BaselineAlias::Relation::kOwnValue) {
    const twin::EffectSetting* const before = baseline.find(effect.id);
    if (before == nullptr) return std::nullopt;
    return value / before->values[alias.parameter];
  }
  const double was = numberIn(baseline, alias.number), is = numberIn(hypothesis, alias.number);
  return alias.together(is, value) / was;
}

}  // namespace

bool isAliasOf(const twin::EffectInfo& effect, std::string_view number) {
  return std::ranges::find(effect.aliases, number, &twin::BaselineAlias::number) != effect.aliases.end();
}

bool aliasesAPrior(const Case& data, const twin::EffectInfo& effect) {
  return std::ranges::any_of(data.priors, [&](const Prior& prior) { return isAliasOf(effect, prior.number); });
}

double priorSigmasMoved(const Case& data, const Hypothesis& baseline, const Hypothesis& hypothesis,
                        const twin::EffectInfo& effect) {
  if (effect.aliases.empty()) return kInfinity;
  double most = 0;
  for (const twin::BaselineAlias& alias : effect.aliases) {
    const std::optional<double> factor = changeOf(alias, effect, baseline, hypothesis);
    if (factor == 1) continue;
    const auto prior = std::ranges::find(data.priors, alias.number, &Prior::number);
    if (!factor || prior == data.priors.end() || !(prior->relative_sigma > 0)) return kInfinity;
    most = std::max(most, std::abs(*factor - 1) / prior->relative_sigma);
  }
  return most;
}

double numberIn(const Hypothesis& hypothesis, std::string_view name) {
  const auto found = std::ranges::find(kBaselineNumbers, name, &BaselineNumber::name);
  if (found == kBaselineNumbers.end()) return std::numeric_limits<double>::quiet_NaN();
  if (const auto* const servo = std::get_if<ServoFactor>(&found->what)) return hypothesis.servo.**servo;
  const auto load = std::get<LoadFactor>(found->what);
  if (load == LoadFactor::kPayload) return hypothesis.payload_scale;
  return load == LoadFactor::kLength ? hypothesis.pendulum.length_m : hypothesis.pendulum.arm_mass_kg;
}

}  // namespace darwinop::gap
