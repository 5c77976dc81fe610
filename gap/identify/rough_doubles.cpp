// Where no log shows an effect, a fit prefers one of its doubles by chance: those that predict as well are rivals.
#include <algorithm>
#include <utility>

#include "gap/identify/assessment.hpp"
#include "gap/identify/rough_selection.hpp"
#include "gap/identify/shortlist.hpp"
#include "gap/identify/shown.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

using EffectList = std::vector<const twin::EffectInfo*>;

bool contains(const EffectList& list, const twin::EffectInfo* effect) {
  return std::ranges::find(list, effect) != list.end();
}

/// Each of `doubles` beside the same effects of the model: one screen is enough for all.
struct Trial {
  Effects kept;
  EffectList doubles;
};

/// A double replaces what it is confused with, if that is hidden; and if both are, all that is hidden in the same part
/// of the loop.
std::vector<Trial> trialsOf(const FittedModel& model, const EffectList& candidates, const EffectList& hidden) {
  std::vector<Trial> trials;
  for (const twin::EffectInfo* const one : candidates) {
    if (has(model.effects, *one) || aliasesAPrior(model.study->data, *one)) continue;
    const EffectList like = twin::doublesOf(*one);
    Effects without_part = model.effects, without_doubles = model.effects;
    std::erase_if(without_doubles, [&](const ChosenEffect& effect) {
      return contains(hidden, effect.info) && contains(like, effect.info);
    });
    if (without_doubles.size() == model.effects.size()) continue;
    std::erase_if(without_part, [&](const ChosenEffect& effect) {
      return contains(hidden, effect.info) && (contains(like, effect.info) || effect.info->part == one->part);
    });
    if (!contains(hidden, one)) without_part = without_doubles;
    for (const Effects& kept : {without_doubles, without_part}) {
      auto trial = std::ranges::find(trials, kept, &Trial::kept);
      if (trial == trials.end()) trial = trials.insert(trials.end(), {kept, {}});
      if (!contains(trial->doubles, one)) trial->doubles.push_back(one);
    }
  }
  return trials;
}

/// Under the noise of `model`; those that earn their place.
std::vector<FittedModel> fitEach(const FittedModel& model, const Trial& trial) {
  const FittedModel less = refitUnderNoiseOf(trial.kept, model.nuisance, model.problem, model.fit, model, true);
  std::vector<FittedModel> fitted = shortlist(less, Screen{less, trial.doubles});
  for (FittedModel& one : fitted) one = refitUnderNoiseOf(one, less, true);
  std::erase_if(fitted, [&](const FittedModel& one) {
    return less.fit.cost - one.fit.cost < leastRoughGain(*one.effects.back().info);
  });
  return fitted;
}

}  // namespace

/// Worse neither on the held-out logs nor on those that decide.
bool RoughSelection::predictsAsWell(const FittedModel& other) const {
  const twin::EffectInfo& effect = *other.effects.back().info;
  if (isAtItsBound(other, effect) || isNegligible(other, effect) || worsensHeldOut(other)) return false;
  return !crossValidate(errorsOf(other), errors_, floor_rad_).improves();
}

void RoughSelection::noteDoubles() {
  const std::vector<Trial> trials = trialsOf(model_, candidates_, effectsNotShown(study_.data));
  if (trials.empty()) return;
  options_.progress("effects that these logs do not show: do others predict as well in their place?");
  for (const Trial& trial : trials)
    for (const FittedModel& other : fitEach(model_, trial))
      if (predictsAsWell(other)) rivals_.push_back({idsOf(other.effects), 0, false});
}

}  // namespace darwinop::gap
