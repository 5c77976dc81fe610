// After an effect was added: free what refines it, drop effects that are no longer needed, replace effects that are
// more complex than needed.
#include <algorithm>

#include "gap/identify/selection.hpp"
#include "gap/identify/shortlist.hpp"
#include "gap/plant/baseline_alias.hpp"

namespace darwinop::gap {
namespace {

/// Effects that `rich` is easily confused with and that have fewer parameters; none that stands for a baseline number.
std::vector<const twin::EffectInfo*> simplerThan(const twin::EffectInfo& rich, const FittedModel& model,
                                                 const std::vector<const twin::EffectInfo*>& candidates) {
  std::vector<const twin::EffectInfo*> simpler;
  for (const auto* effect : candidates)
    if (std::ranges::find(rich.confused_with, effect->id) != rich.confused_with.end() && !has(model.effects, *effect) &&
        !aliasesAPrior(model.study->data, *effect) && unknownsOf(*effect).size() < unknownsOf(rich).size())
      simpler.push_back(effect);
  return simpler;
}

}  // namespace

double Selection::gainOf(std::size_t i) const {
  return refitWithout(model_, i).fit.cost - model_.fit.cost;
}

double Selection::leastGainOf(const twin::EffectInfo& effect) const {
  return leastGain(study_, model_.hypothesis(), effect, threshold_);
}

// The residual may be due to the shape of the effect just added, before it is due to another effect.
void Selection::freeSecondaryParameters() {
  const ChosenEffect& last = model_.effects.back();
  if (unknownsOf(*last.info, true).size() == unknownsOf(*last.info).size()) return;
  Effects finer = model_.effects;
  finer.back().refined = true;
  const FittedModel refined = refitUnderNoiseOf(finer, model_.nuisance, model_.problem, model_.fit, model_);
  if (model_.fit.cost - refined.fit.cost > threshold_) model_ = refit(refined, finer, 2);
}

// An earlier effect may have stood in for the one just added.
void Selection::dropNeedless() {
  for (std::size_t i = 0; model_.effects.size() > 1 && i + 1 < model_.effects.size();) {
    const FittedModel less = refitWithout(model_, i);
    const double gain = less.fit.cost - model_.fit.cost;
    if (gain < leastGainOf(*model_.effects[i].info)) {
      report("%s is no longer needed", std::string{model_.effects[i].info->id}.c_str());
      model_ = refit(less, less.effects, 2);
      gains_.erase(gains_.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      gains_[i++] = gain;
    }
  }
}

// An effect that was chosen while others were missing may have more parameters than it needs: friction that is the same
// in both directions needs no directional law.
bool Selection::simplifyOne() {
  for (std::size_t i = 0; i + 1 < model_.effects.size(); ++i) {
    const twin::EffectInfo& rich = *model_.effects[i].info;
    const std::vector<const twin::EffectInfo*> simpler = simplerThan(rich, model_, candidates_);
    if (simpler.empty()) continue;
    const FittedModel less = refitWithout(model_, i, true);
    const std::vector<FittedModel> candidates = fitCandidates(less, Screen{less, simpler}, simpler);
    if (candidates.empty()) continue;
    const FittedModel& best = candidates.front();
    const twin::EffectInfo& info = *best.effects.back().info;
    // Each under the noise of the other: the simpler one has to be ahead under both.
    const FittedModel here = refitUnderNoiseOf(best, model_, true), there = refitUnderNoiseOf(model_, best, true);
    const double gain = less.fit.cost - here.fit.cost;
    const bool ahead = modelEvidence(here) > modelEvidence(model_) && modelEvidence(best) > modelEvidence(there);
    if (!ahead || gain < neededFor(info) || isAtItsBound(best, info) || isNegligible(best, info)) continue;
    report("%s explains as much as %s", std::string{info.id}.c_str(), std::string{rich.id}.c_str());
    replace(i, best, gain);
    return true;
  }
  return false;
}

/// Effect `i` by the last effect of `simpler`.
void Selection::replace(std::size_t i, const FittedModel& simpler, double gain) {
  const twin::EffectInfo& rich = *model_.effects[i].info;
  const std::string was{rich.id}, is{simpler.effects.back().info->id};
  for (Rival& rival : rivals_) {
    if (std::ranges::find(rival.effects, is) != rival.effects.end()) rival.effects.clear();
    std::ranges::replace(rival.effects, was, is);
  }
  std::erase_if(rivals_, [](const Rival& rival) { return rival.effects.empty(); });
  Effects effects = model_.effects;
  effects[i] = simpler.effects.back();
  model_ = refit(simpler, effects, 1);
  gains_[i] = gain;
  std::erase(candidates_, &rich);  // else the two could replace each other endlessly
}

// Each effect but the last was chosen while something else was missing as well.
bool Selection::swapOne() {
  for (std::size_t i = 0; i + 1 < model_.effects.size(); ++i) {
    const FittedModel less = refit(model_, without(model_.effects, i), 1);
    const std::vector<FittedModel> candidates = fitCandidates(less, Screen{less, candidates_});
    if (candidates.empty() || candidates.front().effects.back().info == model_.effects[i].info) continue;
    const FittedModel& best = candidates.front();
    const double gain = refitUnderNoiseOf(model_, best).fit.cost - best.fit.cost;
    if (gain < threshold_) continue;
    report("%s explains more than %s", std::string{best.effects.back().info->id}.c_str(),
           std::string{model_.effects[i].info->id}.c_str());
    gains_.erase(gains_.begin() + static_cast<std::ptrdiff_t>(i));
    add(best, gain, threshold_, candidates);
    prune();
    return true;
  }
  return false;
}

}  // namespace darwinop::gap
