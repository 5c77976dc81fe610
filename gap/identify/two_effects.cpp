#include "gap/identify/two_effects.hpp"

#include <algorithm>

#include "gap/identify/assessment.hpp"
#include "gap/identify/selection.hpp"

namespace darwinop::gap {
namespace {

/// Effects that loads and goals alone show: no number of the mechanics can stand in for them.
Effects inTheFirmware(const Effects& effects) {
  Effects firmware;
  for (const ChosenEffect& effect : effects)
    if (effect.info->part == twin::LoopPart::kCommand || effect.info->part == twin::LoopPart::kController)
      firmware.push_back({effect.info});
  return firmware;
}

/// True if an effect is at the end of its range. Where an arm may get stuck or not, so much counts as noise that it
/// can leave nothing else.
bool standsForSomethingElse(const FittedModel& found) {
  return std::ranges::any_of(found.effects,
                             [&](const ChosenEffect& effect) { return isAtItsBound(found, *effect.info); });
}

bool explains(const Selection& selection) {
  return selection.leavesNoise() && !standsForSomethingElse(selection.model());
}

}  // namespace

TwoEffects searchTwoEffects(const Study& study, const Study& few, IdentifyOptions options) {
  options.most_effects = 2;
  Selection some{few, options, Nuisance::kFree};
  some.run();
  const FittedModel& model = some.model();
  TwoEffects found{std::nullopt,
                   refit(few, inTheFirmware(model.effects), Nuisance::kFree, model.problem, model.fit, 1)};
  if (!explains(some)) return found;
  if (&few == &study) {
    found.explained = some.result();
    return found;
  }
  // What leaves only noise in all logs leaves only noise in some: real servos have more effects than two, and of many
  // logs a few show that in a fraction of the time.
  Selection all{study, options, Nuisance::kFree};
  all.adopt(some);
  if (explains(all)) return searchTwoEffects(study, study, options);
  return found;
}

}  // namespace darwinop::gap
