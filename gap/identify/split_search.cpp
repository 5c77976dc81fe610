#include "gap/identify/split_search.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "gap/identify/assessment.hpp"
#include "gap/identify/cross_validation.hpp"
#include "gap/identify/held_out.hpp"
#include "gap/identify/selection.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

using Logs = std::vector<std::size_t>;

/// The fit logs, copies of a log once, in the order in which they were recorded.
Logs inSessionOrder(const Study& study) {
  Logs logs = study.evidence.logs;
  std::ranges::stable_sort(logs, {}, [&](std::size_t i) { return study.data.logs[i].session_start_s; });
  return logs;
}

Case withFitLogs(Case given, const Logs& logs) {
  for (std::size_t i = 0; i < given.logs.size(); ++i) given.logs[i].held_out = std::ranges::find(logs, i) == logs.end();
  return given;
}

/// The effects of `found` as a fit to the logs of `study`.
FittedModel refitted(const Study& study, const Identification& found) {
  Effects effects;
  for (const IdentifiedEffect& one : found.effects) effects.push_back({one.effect});
  const Problem problem = problemWith(study, study.evidence, effects, Nuisance::kFree);
  Fit start;
  start.x = problem.expected();
  for (std::size_t i = 0; i < problem.unknowns().size(); ++i)
    for (const IdentifiedEffect& one : found.effects)
      for (const Estimate& estimate : one.estimates)
        if (estimate.name == problem.unknowns()[i].name)
          start.x[static_cast<Eigen::Index>(i)] = problem.unknowns()[i].toSearch(estimate.value);
  return refit(study, effects, Nuisance::kFree, problem, start, 2);
}

/// Mean |position error| of each log outside of the fit, rad.
std::vector<double> errorsOutside(const Study& study, const Hypothesis& model) {
  std::vector<double> errors;
  Case one = study.data;
  for (Trajectory& log : one.logs) log.held_out = true;
  for (std::size_t i = 0; i < one.logs.size(); ++i) {
    if (!study.data.logs[i].held_out) continue;
    one.logs[i].held_out = false;
    const double error = meanPositionError(study.plant, one, model, LogRole::kFit);
    if (std::isfinite(error)) errors.push_back(error);  // else a copy of another log
    one.logs[i].held_out = true;
  }
  return errors;
}

/// Noise floor of each of these logs, rad: a release among the fitted ones would hide what others show.
std::vector<double> floorsOutside(const Study& study, const Hypothesis& model) {
  Case others = study.data;
  for (Trajectory& log : others.logs) log.held_out = !log.held_out;
  std::vector<double> floors;
  for (const LogNoise& noise : evidenceOf(study.plant, others, model).noise)
    floors.push_back(noise.positionFloor().rms());
  return floors;
}

/// On none of the logs the error is larger by more than noise.
bool worsensNone(const std::vector<double>& before, const std::vector<double>& after,
                 const std::vector<double>& floors) {
  for (std::size_t i = 0; i < after.size(); ++i)
    if (isWorse(before[i], after[i], floors[i])) return false;
  return true;
}

/// Drops effects that do not improve predictions outside of the half; all, if the baseline predicts a log there better.
void dropUnproven(const Study& half, Identification& found) {
  const FittedModel with = refitted(half, found);
  const std::vector<double> errors = errorsOutside(half, with.hypothesis()),
                            floors = floorsOutside(half, with.hypothesis());
  if (!worsensNone(errorsOutside(half, half.baseline), errors, floors)) return found.effects.clear();
  const double floor_rad = readingSigma(half.data.model.servo);
  std::vector<IdentifiedEffect> proven;
  for (std::size_t i = 0; i < found.effects.size(); ++i) {
    const std::vector<double> without = errorsOutside(half, modelWithout(with, i));
    if (worsensNone(without, errors, floors) && crossValidate(without, errors, floor_rad).improves()) {
      proven.push_back(found.effects[i]);
      continue;
    }
    found.rejected.push_back({found.effects[i].effect, RejectionReason::kNoPredictiveGain});
    takeOut(*found.effects[i].effect, half.baseline, found.model);
    found.rivals.clear();  // of the last effect, in the company of all
  }
  found.effects = std::move(proven);
}

/// Misfit of a given model on all logs.
double misfitOn(const Study& study, const Hypothesis& model) {
  auto evidence = std::make_shared<const Evidence>(evidenceOf(study.plant, study.data, model));
  Problem problem{*evidence, model, {}};
  Fit fit = solve(problem, problem.expected(), {.iterations = 0, .refine = false});
  const FittedModel given{&study, {}, Nuisance::kFixed, std::move(evidence), std::move(problem), std::move(fit), 0};
  return misfitOf(given, bootstrapOf(given, nullptr, thresholds::kFewBootstrapRuns));
}

/// What leaves nothing but noise in these logs. One search with the numbers of the baseline fixed; if its effects do
/// not explain all, the numbers move to meet them. A search with free numbers takes several times as long, for effects
/// that half of the logs would rarely determine.
std::optional<Identification> explain(const Study& half, const IdentifyOptions& options) {
  Selection selection{half, options, Nuisance::kFixed};
  selection.run();
  if (selection.model().effects.empty()) return std::nullopt;
  if (selection.isConsistent()) return selection.result();
  if (selection.leavesMostOfTheGap()) return std::nullopt;
  Selection free{half, options, Nuisance::kFree};
  free.adopt(selection);
  if (!free.isConsistent()) return std::nullopt;
  return free.result();
}

std::optional<Identification> foundIn(const Study& study, const Logs& logs, const IdentifyOptions& options) {
  const Case part = withFitLogs(study.data, logs);
  const Study half{part};
  std::optional<Identification> explained = explain(half, options);
  if (!explained) return std::nullopt;
  Identification& found = *explained;
  const bool named = found.verdict == Verdict::kNamed || found.verdict == Verdict::kAmbiguous;
  if (!named) return std::nullopt;
  dropUnproven(half, found);
  if (found.effects.empty() || worsensHeldOut(study, found.model, found.floor_rad)) return std::nullopt;
  found.verdict = namedOrAmbiguous(found);
  found.remains = true;
  found.misfit = misfitOn(study, found.model);
  found.gap_before_rad = study.gap_rad;
  found.gap_after_rad = rmsPositionError(study.plant, study.data, found.model, LogRole::kFit);
  for (const std::size_t log : logs) found.explained.push_back(study.data.logs[log].file);
  return explained;
}

}  // namespace

std::optional<Identification> searchInHalves(const Study& study, const IdentifyOptions& options) {
  const Logs all = inSessionOrder(study);
  // Without the session's clock the order of the logs is that of their names.
  if (!std::ranges::all_of(all, [&](std::size_t i) { return study.data.logs[i].is_session_known; }))
    return std::nullopt;
  const auto half = static_cast<std::ptrdiff_t>(all.size() / 2);
  if (half < 3) return std::nullopt;
  for (const Logs& logs : {Logs(all.begin(), all.begin() + half), Logs(all.end() - half, all.end())})
    if (std::optional<Identification> found = foundIn(study, logs, options)) return found;
  return std::nullopt;
}

}  // namespace darwinop::gap
