// The loop: screen, refine, select, cross-validate, prune. select.cpp and prune.cpp have the steps, pairs.cpp the way
// out of a saddle; verdict.cpp turns the result into a verdict.
#include "gap/identify/selection.hpp"

#include <algorithm>

#include "gap/identify/shortlist.hpp"
#include "gap/identify/stuck_log.hpp"
#include "gap/plant/baseline_alias.hpp"

namespace darwinop::gap {
Selection::Selection(const Study& study, const IdentifyOptions& options, Nuisance nuisance)
    : study_{study},
      options_{options},
      candidates_{candidateEffectsOf(study.data)},
      bare_{baselineAlone(study, nuisance)},
      model_{bare_} {}

void Selection::run() {
  search();
  if (beganAtASaddle() && takeBetterPair()) search();
}

void Selection::search() {
  bool swapped = false;
  for (;;) {
    if (isFull()) {
      assess(nullptr);
      if (leavesNoise() || !improvePastAStuckLog()) return;
      continue;
    }
    const Screen screen{model_, candidates_};  // predicted gain of every effect, by linear algebra
    assess(&screen);                           // misfit, and the gain that chance alone predicts
    if (isExplained(screen)) return;

    if (mayAdd() && addOne(screen)) continue;  // refine, select, cross-validate, prune
    if (improvePastAStuckLog()) continue;

    // The first effects were chosen while others were missing: replace one of them, once.
    if (swapped || !maySwap() || !swapOne()) return;
    swapped = true;
  }
}

/// Where noise explains the residual, effects that stand for a number in conflict with its prior are tried first.
bool Selection::addOne(const Screen& screen) {
  const std::vector<const twin::EffectInfo*> aliases = aliasesInConflict();
  if (!aliases.empty() && addFrom(fitCandidates(model_, screen, aliases))) return true;
  return addFrom(fitCandidates(model_, screen));
}

/// Adds the best of the fitted candidates, or refits the present effects from the optimum that a candidate found.
bool Selection::addFrom(const std::vector<FittedModel>& candidates) {
  const Choice choice = choose(candidates);
  rejected_ = choice.rejected;
  if (choice.model != nullptr) {
    rejected_.clear();
    add(*choice.model, choice.gain, choice.needed, candidates);
    prune();
    return true;
  }
  return std::ranges::any_of(choice.present, [&](const FittedModel& same) { return improveFrom(same); });
}

bool Selection::improvePastAStuckLog() {
  if (model_.effects.empty()) return false;  // baselineAlone() has done it
  const std::optional<FittedModel> past = fittedPastAStuckLog(model_);
  return past && improveFrom(*past);
}

void Selection::prune() {
  freeSecondaryParameters();
  dropNeedless();
  while (simplifyOne()) {
  }
}

void Selection::assess(const Screen* screen) {
  const bool plainly_wrong =
      model_.fit.cost > thresholds::kPlainCost * static_cast<double>(model_.fit.residuals.size());
  const Bootstrap bootstrap =
      bootstrapOf(model_, screen, plainly_wrong ? thresholds::kFewBootstrapRuns : thresholds::kBootstrapRuns);
  misfit_ = misfitOf(model_, bootstrap);
  excess_cost_ = model_.fit.cost - model_.fit.prior - bootstrap.cost_mean;
  if (screen != nullptr) threshold_ = bootstrap.threshold(options_.alpha);
  report("misfit %.1f standard deviations; chance alone gains %.0f", misfit_, threshold_);
}

// A roughly known baseline has its own search for better effects, RoughSelection.
bool Selection::maySwap() const {
  return !isConsistent() && !isRoughlyKnown(study_.data);
}

/// Nothing may be added or replaced: what a further effect would gain decides nothing.
bool Selection::isFull() const {
  return isRoughlyKnown(study_.data) && static_cast<int>(model_.effects.size()) >= options_.most_effects;
}

bool Selection::isExplained(const Screen& screen) const {
  if (!model_.effects.empty() && isNearlyExact()) return true;
  return leavesNoise() && screen.candidates().front().predicted_gain < thresholds::kChanceMargin * threshold_ &&
         largestPriorSigma(model_) < thresholds::kPriorTensionSigmas;
}

bool Selection::mayAdd() const {
  const int most = model_.nuisance == Nuisance::kFixed ? std::min(thresholds::kMaxEffectsFixed, options_.most_effects)
                                                       : options_.most_effects;
  return static_cast<int>(model_.effects.size()) < most && !leavesMostOfTheGap();
}

std::vector<const twin::EffectInfo*> Selection::aliasesInConflict() const {
  std::vector<const twin::EffectInfo*> aliases;
  if (largestPriorSigma(model_) <= thresholds::kPriorTensionSigmas || !leavesNoise()) return aliases;
  for (const auto* effect : candidates_)
    if (aliasesAPrior(study_.data, *effect) && !has(model_.effects, *effect)) aliases.push_back(effect);
  return aliases;
}

void Selection::adopt(const Selection& other) {
  adopt(other, other.model_.effects);
  gains_ = other.gains_, rivals_ = other.rivals_;
}

void Selection::adopt(const Selection& other, const Effects& effects) {
  const FittedModel& found = other.model_;
  model_ = refit(study_, effects, model_.nuisance, found.problem, found.fit, 2);
  gains_.assign(effects.size(), 0);
  for (std::size_t i = 0; i < effects.size(); ++i) gains_[i] = gainOf(i);
  rivals_.clear();
  threshold_ = other.threshold_;
  assess(nullptr);
}

}  // namespace darwinop::gap
