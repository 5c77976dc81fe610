// Two selections: one takes every number of the baseline as exact, one lets the numbers move within their priors. The
// simpler explanation wins, by its evidence.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "gap/identify/assessment.hpp"
#include "gap/identify/cross_validation.hpp"
#include "gap/identify/fewer_logs.hpp"
#include "gap/identify/rough_selection.hpp"
#include "gap/identify/selection.hpp"
#include "gap/identify/split_search.hpp"
#include "gap/identify/two_effects.hpp"
#include "gap/plant/baseline_alias.hpp"

namespace darwinop::gap {
namespace {

/// The best consistent explanation with free numbers that uses at most the effects of `exact` and has more evidence.
std::optional<Selection> withFreeNumbers(const Selection& exact, const Selection& free) {
  std::optional<Selection> best;
  double most = modelEvidence(exact.model());
  const auto look = [&](const Effects& effects) {
    Selection one = free;
    one.adopt(exact, effects);
    if (!one.isConsistent()) return;
    const double evidence = modelEvidence(refitUnderNoiseOf(one.model(), exact.model(), true));
    if (evidence <= most) return;
    most = evidence;
    best.emplace(one);
  };
  const Effects& effects = exact.model().effects;
  look({});
  look(effects);
  if (effects.size() < 2) return best;
  for (const ChosenEffect& effect : effects) look({effect});
  for (const auto* runner_up : exact.runnersUp())
    if (!has(effects, *runner_up)) look({{runner_up}});
  return best;
}

/// Several effects, one of which stands for a baseline number: it may stand for many numbers, each a little off.
bool relyOnABaselineNumber(const Case& data, const Effects& effects) {
  return effects.size() > 1 &&
         std::ranges::any_of(effects, [&](const ChosenEffect& effect) { return aliasesAPrior(data, *effect.info); });
}

Identification identifyOnRoughBaseline(const Study& study, const IdentifyOptions& options) {
  options.progress("roughly known motor: numbers of the baseline move within their priors");
  const FewerLogs fewer{study};
  const TwoEffects two = searchTwoEffects(study, fewer.study(), options);
  if (two.explained) return *two.explained;
  options.progress("no effect explains the residual: selecting effects by cross-validation");
  RoughSelection rough{study, fewer.study(), options, two.firmware};
  rough.run();
  return rough.result();
}

Identification searchAllLogs(const Study& study, const IdentifyOptions& options) {
  options.progress("numbers of the baseline fixed");
  Selection exact{study, options, Nuisance::kFixed};
  exact.run();
  if (exact.isConsistent() && exact.model().effects.empty()) return exact.result();

  options.progress("numbers of the baseline free within their priors");
  Selection free{study, options, Nuisance::kFree};
  if (exact.isConsistent() && !relyOnABaselineNumber(study.data, exact.model().effects)) {
    const std::optional<Selection> better = withFreeNumbers(exact, free);
    return better ? better->result() : exact.result();
  }
  free.run();
  if (free.isConsistent() && !free.model().effects.empty()) {
    options.progress("the same effects, numbers of the baseline fixed");
    exact.adopt(free);
  }
  if (exact.isConsistent() && modelEvidence(exact.model()) > modelEvidence(free.model())) return exact.result();
  if (free.explainsAll()) return free.result();
  // Moved numbers that explain nothing increase the error on other logs.
  if (free.model().effects.empty() || free.leavesMostOfTheGap()) return exact.result();
  const CrossValidation validation = crossValidate(exact.model(), free.model());
  return validation.mean > validation.error ? free.result() : exact.result();
}

}  // namespace

Identification identify(const Study& study, const IdentifyOptions& options) {
  if (isRoughlyKnown(study.data)) return identifyOnRoughBaseline(study, options);
  Identification found = searchAllLogs(study, options);
  if (found.verdict != Verdict::kUnknown) return found;
  options.progress("no model explains all logs: each half of the session alone");
  if (std::optional<Identification> part = searchInHalves(study, options)) return std::move(*part);
  return found;
}

std::string_view nameOf(Verdict verdict) {
  static constexpr std::array<std::string_view, 6> kNames{"none",    "named",       "ambiguous",
                                                          "unknown", "cannot_tell", "bad_input"};
  return kNames.at(static_cast<std::size_t>(verdict));
}

std::string_view nameOf(RejectionReason reason) {
  static constexpr std::array<std::string_view, 5> kNames{"voltage", "undecided", "no_predictive_gain",
                                                          "worsens_held_out", "small_share"};
  return kNames.at(static_cast<std::size_t>(reason));
}

int exitCodeOf(Verdict verdict) {
  static constexpr std::array<int, 6> kCodes{0, 10, 11, 12, 13, 2};
  return kCodes.at(static_cast<std::size_t>(verdict));
}

}  // namespace darwinop::gap
