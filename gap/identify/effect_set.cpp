#include "gap/identify/effect_set.hpp"

#include <algorithm>
#include <cmath>

#include "gap/fit/servo_range.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

bool canActIn(const Case& data, twin::Laws laws) {
  const bool voltage = data.model.servo.law == twin::Law::kVoltageP;
  switch (laws) {
    case twin::Laws::kBoth:
      return true;
    case twin::Laws::kVoltageP:
      return voltage;
    case twin::Laws::kReplacesSpeedP:
      return !voltage && data.datasheet;
  }
  return false;
}

}  // namespace

std::vector<const twin::EffectInfo*> candidateEffectsOf(const Case& data) {
  std::vector<const twin::EffectInfo*> effects;
  for (const twin::EffectInfo* const effect : twin::catalogue())
    if (effect->visibility == twin::Visibility::kAtHost && canActIn(data, effect->laws)) effects.push_back(effect);
  return effects;
}

bool has(const Effects& effects, const twin::EffectInfo& effect) {
  return std::any_of(effects.begin(), effects.end(),
                     [&](const ChosenEffect& chosen) { return chosen.info == &effect; });
}

std::vector<std::string> idsOf(const Effects& effects) {
  std::vector<std::string> ids;
  for (const ChosenEffect& effect : effects) ids.emplace_back(effect.info->id);
  return ids;
}

Effects without(Effects effects, std::size_t i) {
  effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(i));
  return effects;
}

bool isRoughlyKnown(const Case& data) {
  return std::ranges::any_of(data.priors, [](const Prior& prior) {
    return (prior.number == "kt" || prior.number == "resistance") && prior.relative_sigma >= thresholds::kRoughPrior;
  });
}

Problem problemWith(const Study& study, const Evidence& evidence, const Effects& effects, Nuisance nuisance) {
  Hypothesis hypothesis = study.baseline;
  std::vector<Unknown> own;
  for (const ChosenEffect& effect : effects) {
    twin::EffectSetting& setting = hypothesis.with(*effect.info, effect.place);
    if (effect.info->laws == twin::Laws::kReplacesSpeedP) setting.values[0] = 1;
  }
  const bool voltage = hypothesis.law() == twin::Law::kVoltageP;
  for (const ChosenEffect& effect : effects)
    for (Unknown& unknown : unknownsOf(*effect.info, study.baseline.servo, effect.refined, effect.place)) {
      const twin::Parameter& parameter = effect.info->parameters[std::get<EffectParameter>(unknown.what).index];
      if (voltage || parameter.laws != twin::Laws::kVoltageP) own.push_back(std::move(unknown));
    }
  std::vector<Unknown> all = nuisancesOf(study.data, hypothesis);
  // Numbers of another law's motor come from a data sheet: they belong to no baseline and are never exact.
  const bool other_motor = hypothesis.law() != hypothesis.servo.law;
  if (nuisance == Nuisance::kFixed)
    std::erase_if(all, [&](const Unknown& one) {
      const bool is_sheets = other_motor && (one.name == "kt" || one.name == "resistance");
      return !is_sheets && !std::holds_alternative<WriteTime>(one.what);
    });
  std::erase_if(all, [&](const Unknown& one) {  // the effect's own parameter replaces it
    return one.name.find('.') != std::string::npos &&
           std::ranges::any_of(effects, [&](const ChosenEffect& chosen) { return isAliasOf(*chosen.info, one.name); });
  });
  all.insert(all.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  return {evidence, std::move(hypothesis), std::move(all)};
}

Eigen::VectorXd startFrom(const Problem& problem, const Problem& known, const Eigen::VectorXd& x) {
  Eigen::VectorXd start = problem.expected();
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i)
    for (std::size_t j = 0; j < known.unknowns().size(); ++j)
      if (problem.unknowns()[i].name == known.unknowns()[j].name) {
        const double value = known.unknowns()[j].fromSearch(x[static_cast<Eigen::Index>(j)]);
        start[static_cast<Eigen::Index>(i)] = problem.unknowns()[i].toSearch(value);
      }
  return start;
}

Eigen::VectorXd startAfresh(const Problem& problem, const Problem& known, const Eigen::VectorXd& x) {
  Eigen::VectorXd start = startFrom(problem, known, x);
  const Eigen::VectorXd expected = problem.expected();
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    if (std::isfinite(problem.unknowns()[i].sigma)) start[at] = expected[at];
  }
  return start;
}

}  // namespace darwinop::gap
