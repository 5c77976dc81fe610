// Which fitted candidate is added: gain over chance, plausible values, prediction of logs left out.
#include <algorithm>
#include <cmath>

#include "gap/identify/cross_validation.hpp"
#include "gap/identify/selection.hpp"
#include "gap/plant/baseline_alias.hpp"

namespace darwinop::gap {

Selection::Choice Selection::choose(const std::vector<FittedModel>& candidates) const {
  Choice choice;
  for (const FittedModel& candidate : candidates) {
    const twin::EffectInfo& effect = *candidate.effects.back().info;
    const FittedModel& present = choice.present.emplace_back(refitUnderNoiseOf(model_, candidate));
    const double gain = present.fit.cost - candidate.fit.cost, needed = neededFor(effect);
    report("%s gains %.0f, needs %.0f", std::string{effect.id}.c_str(), gain, needed);
    if (!passes(candidate, gain, needed)) {
      if (gain > threshold_ && gain < needed) choice.rejected.push_back({&effect, RejectionReason::kSmallShare});
      continue;
    }
    if (staysInsideItsPrior(candidate, effect)) {
      // With exact numbers the best explanation is a number inside its prior: a weaker candidate is not a finding.
      if (model_.nuisance == Nuisance::kFixed && &candidate == &candidates.front()) {
        choice.present.clear();
        return choice;
      }
      continue;
    }
    if (!predictsBetter(candidate, present, gain)) {
      choice.rejected.push_back({&effect, RejectionReason::kNoPredictiveGain});
      continue;
    }
    choice.model = &candidate, choice.gain = gain, choice.needed = needed;
    return choice;
  }
  return choice;
}

bool Selection::passes(const FittedModel& candidate, double gain, double needed) const {
  const twin::EffectInfo& effect = *candidate.effects.back().info;
  if (gain < needed || isNegligible(candidate, effect)) return false;
  return !isAtItsBound(candidate, effect) || gain >= thresholds::kBoundExcessShare * excess_cost_;
}

bool Selection::staysInsideItsPrior(const FittedModel& candidate, const twin::EffectInfo& effect) const {
  const double most =
      model_.nuisance == Nuisance::kFixed ? thresholds::kFixedNumberSigmas : thresholds::kPriorTensionSigmas;
  return aliasesAPrior(study_.data, effect) &&
         priorSigmasMoved(study_.data, study_.baseline, candidate.hypothesis(), effect) < most;
}

// Under a model that is still plainly wrong any further effect improves the fit. It has to improve predictions as well;
// so has one that a model by the numbers of a manual does not need: as slightly wrong as that is, much gains a little.
// An effect that releases a number of the baseline predicts no better than that number, where it is free.
bool Selection::predictsBetter(const FittedModel& candidate, const FittedModel& present, double gain) const {
  if (model_.effects.empty()) return true;
  const bool is_plainly_wrong =
      excess_cost_ - gain >= thresholds::kCrossValidateCost * static_cast<double>(candidate.fit.residuals.size());
  const bool noise_suffices = leavesNoise() && isRoughlyKnown(study_.data);
  if (!is_plainly_wrong && !noise_suffices) return true;
  if (noise_suffices && aliasesAPrior(study_.data, *candidate.effects.back().info) && !priorConflictsOf(model_).empty())
    return true;
  const CrossValidation validation = crossValidate(present, candidate);
  report("leave-one-log-out prediction error ratio %.2f, %.2f to %.2f", std::exp(validation.mean),
         std::exp(validation.mean - 2 * validation.error), std::exp(validation.mean + 2 * validation.error));
  return validation.improves();
}

double Selection::neededFor(const twin::EffectInfo& effect) const {
  if (aliasesAPrior(study_.data, effect) && largestPriorSigma(model_) > thresholds::kPriorTensionSigmas)
    return thresholds::kPriorReleaseGain;
  const double by_chance = (leavesNoise() ? thresholds::kChanceMargin : 1) * threshold_;
  return std::max(by_chance, thresholds::kLeastExcessShare * excess_cost_);
}

void Selection::add(const FittedModel& best, double gain, double needed, const std::vector<FittedModel>& candidates) {
  rivals_.clear();
  for (const FittedModel& other : candidates) {
    if (&other == &best) continue;
    const twin::EffectInfo* const effect = other.effects.back().info;
    if (std::ranges::find(runners_up_, effect) == runners_up_.end()) runners_up_.push_back(effect);
    if (neededFor(*effect) > needed) continue;
    double behind = modelEvidence(best) - modelEvidence(other);
    // A rival that needs a number beyond its prior, where the best does not, leaves part of the gap unexplained.
    if (largestPriorSigma(other) > thresholds::kPriorTensionSigmas &&
        largestPriorSigma(best) < thresholds::kPriorTensionSigmas)
      behind = std::max(behind, thresholds::kRivalEvidence);
    rivals_.push_back({idsOf(other.effects), behind, other.problem.unknowns().size() > best.problem.unknowns().size()});
  }
  if (model_.effects.empty()) first_share_ = excess_cost_ > 0 ? gain / excess_cost_ : 1;
  gains_.push_back(gain);
  model_ = best.fit.jacobian.size() > 0 ? best : refit(best, best.effects, 1);
}

// Under other noise the same effects may have left a local minimum.
bool Selection::improveFrom(const FittedModel& same) {
  if (model_.effects.empty() || refitUnderNoiseOf(same, model_).fit.cost > model_.fit.cost - threshold_) return false;
  FittedModel better = refit(same, same.effects, 2);
  const double gain = model_.total - better.total;
  if (gain < threshold_) return false;
  report("the same effects gain %.0f from another start", gain);
  model_ = std::move(better);
  for (Rival& rival : rivals_) rival.behind += gain;
  dropNeedless();
  gains_.back() = gainOf(model_.effects.size() - 1);
  if (model_.effects.size() > 1 && gains_.back() < leastGainOf(*model_.effects.back().info)) {
    gains_.pop_back();
    model_ = refit(model_, without(model_.effects, gains_.size()), 2);
  }
  return true;
}

}  // namespace darwinop::gap
