// Effects that every servo has, fitted together from several starts; what is needless or at the end of its range is
// refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gap/case/median.hpp"
#include "gap/case/plausible.hpp"
#include "gap/identify/assessment.hpp"
#include "gap/identify/jackknife.hpp"
#include "gap/identify/rough_selection.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

/// A start with these effects, every number of the baseline at its expected value.
FittedModel restarted(const Effects& effects, const FittedModel& from) {
  Problem problem = problemWith(*from.study, *from.evidence, effects, Nuisance::kFree);
  Fit fit;
  fit.x = startAfresh(problem, from.problem, from.fit.x);
  return {from.study, effects, Nuisance::kFree, from.evidence, std::move(problem), std::move(fit), 0};
}

// From one start alone a swing that is out of phase may never come back.
struct Start {
  double strength;  // of a scale parameter: times its typical value
  double side;      // of a parameter of either sign
};
constexpr std::array kStarts{Start{1, 1}, Start{0.3, 0}, Start{1, -1}};

FittedModel startedAt(const Start& start, FittedModel fitted) {
  const auto& unknowns = fitted.problem.unknowns();
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const auto* const parameter = std::get_if<EffectParameter>(&unknowns[i].what);
    if (parameter == nullptr || !isCommon(*parameter->info)) continue;
    double& x = fitted.fit.x[static_cast<Eigen::Index>(i)];
    x = unknowns[i].logarithmic ? x + std::log(start.strength) : start.side * x;
  }
  return fitted;
}

/// The logs for validation, one of each motion and bench: repeats share what the model lacks, and those of a fitted log
/// would confirm what stands for it there. One that was cut short shows little, and counts as much as others.
Case validationLogsOf(const Case& given) {
  std::vector<double> durations;
  for (const Trajectory& log : given.others)
    if (!log.held_out) durations.push_back(log.duration_s());
  const double usual_s = medianOf(durations);
  Case validation = given;
  validation.logs.clear();
  const auto repeats_one_of = [](const std::vector<Trajectory>& logs, const Trajectory& log) {
    return std::ranges::any_of(logs, [&](const Trajectory& other) { return isRepeat(log, other); });
  };
  for (const Trajectory& log : given.others)
    if (!log.held_out && log.duration_s() >= usual_s / 2 && !repeats_one_of(given.logs, log) &&
        !repeats_one_of(validation.logs, log))
      validation.logs.push_back(log);
  validation.others.clear();
  return validation;
}

}  // namespace

bool isCommon(const twin::EffectInfo& effect) {
  return effect.prevalence == twin::Prevalence::kCommon;
}

double leastRoughGain(const twin::EffectInfo& effect) {
  return isCommon(effect) ? thresholds::kCommonEffectGain : thresholds::kRareEffectGain;
}

bool isNeedless(const twin::EffectInfo& effect, const FittedModel& with, const FittedModel& less) {
  return less.fit.cost - with.fit.cost < leastRoughGain(effect);
}

FittedModel refitWithDiscrepancy(const Effects& effects, const FittedModel& from) {
  return refitWithDiscrepancy(*from.study, effects, from);
}

FittedModel refitWithDiscrepancy(const Study& study, const Effects& effects, const FittedModel& from) {
  Evidence evidence{
      .plant = &study.plant, .given = &study.data, .logs = study.evidence.logs, .noise = {}, .discrepancy = {}};
  evidence.discrepancy = discrepancyOf(study.plant, study.data, evidence.logs, from.hypothesis());
  return refit(study, effects, Nuisance::kFree, {evidence, from.problem.hypothesis(), from.problem.unknowns()},
               from.fit, 2);
}

RoughSelection::RoughSelection(const Study& study, const Study& few, const IdentifyOptions& options,
                               const FittedModel& from)
    : study_{study},
      few_{few},
      options_{options},
      validation_{validationLogsOf(study.data)},
      floor_rad_{readingSigma(study.data.model.servo)},
      candidates_{candidateEffectsOf(study.data)},
      model_{
          refitWithDiscrepancy(from.effects, refitWithDiscrepancy(study, from.effects, restarted(from.effects, from)))},
      errors_{errorsOf(model_)} {}

bool RoughSelection::validationSuffices() const {
  const std::size_t fitted = independentLogs(study_.evidence).size();
  return validation_.logs.size() >= std::max<std::size_t>(CrossValidation::kFewestLogs, fitted);
}

std::vector<double> RoughSelection::errorsOf(const FittedModel& fitted) const {
  std::vector<double> errors = predictionErrors(study_.plant, validation_, fitted.hypothesis());
  if (validationSuffices()) return errors;
  const std::vector<double> left_out = leaveOneOutErrors(fitted);
  errors.insert(errors.end(), left_out.begin(), left_out.end());
  return errors;
}

void RoughSelection::addCommonEffects() {
  options_.progress("effects that every servo has: friction of three kinds, encoder offset");
  const FittedModel bare = model_;
  Effects common = model_.effects;
  for (const twin::EffectInfo* const effect : candidates_)
    if (isCommon(*effect) && !has(common, *effect)) common.push_back({effect});
  model_ = fitFromStarts(common, bare);
  dropNeedless();
  // Without it the others are searched again: it had pulled them to where they do not belong.
  for (std::optional<std::size_t> bound = leastAtBound(); bound; bound = leastAtBound()) {
    std::erase(common, model_.effects[*bound]);
    model_ = fitFromStarts(common, bare);
    dropNeedless();
  }
  std::vector<double> with = errorsOf(model_);
  if (crossValidate(errors_, with, floor_rad_).improves())
    errors_ = std::move(with);
  else
    model_ = bare;
}

/// Fitted to a few logs from each start; the one with the least error in all of them is fitted to all.
FittedModel RoughSelection::fitFromStarts(const Effects& effects, const FittedModel& bare) const {
  FittedModel best = bare;
  double least = std::numeric_limits<double>::infinity();
  for (const Start& start : kStarts) {
    // The second refit has less discrepancy to accept as noise.
    const FittedModel first = refitWithDiscrepancy(few_, effects, startedAt(start, restarted(effects, bare)));
    FittedModel second = refitWithDiscrepancy(few_, effects, first);
    const double error = meanPositionError(study_.plant, study_.data, second.hypothesis(), LogRole::kFit);
    if (error < least) least = error, best = std::move(second);
  }
  if (&few_ == &study_) return best;
  return refitWithDiscrepancy(effects, refitWithDiscrepancy(study_, effects, best));
}

void RoughSelection::dropNeedless() {
  for (std::size_t i = 0; i < model_.effects.size();) {
    const FittedModel less = refitWithout(model_, i);
    if (isNeedless(*model_.effects[i].info, model_, less))
      model_ = refitWithDiscrepancy(less.effects, less);
    else
      ++i;
  }
}

// At the end: while another effect is missing, logs disagree about numbers that are right. Of servos without one, two
// of four folders of logs had a zero error of the encoder, which took a part of the friction.
void RoughSelection::dropUncertain() {
  for (std::size_t i = 0; i < model_.effects.size();) {
    const ChosenEffect effect = model_.effects[i];
    if (mayBeNone(model_, effect)) {
      FittedModel less = refitWithDiscrepancy(without(model_.effects, i), model_);
      std::vector<double> errors = errorsOf(less);
      if (crossValidate(errors, errors_, floor_rad_).mean < thresholds::kRareEffectHelp) {
        model_ = std::move(less), errors_ = std::move(errors);
        for (Rival& rival : rivals_) std::erase(rival.effects, effect.info->id);
        continue;
      }
    }
    ++i;
  }
}

/// Of the effects at the end of their range, that which the model misses least: it stands for something else, and would
/// go on beyond the range.
std::optional<std::size_t> RoughSelection::leastAtBound() const {
  std::optional<std::size_t> found;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model_.effects.size(); ++i) {
    if (!isAtItsBound(model_, *model_.effects[i].info)) continue;
    const double cost = refitWithout(model_, i).fit.cost;
    if (!found || cost < least) least = cost, found = i;
  }
  return found;
}

void RoughSelection::dropAtBounds() {
  for (std::optional<std::size_t> bound = leastAtBound(); bound; bound = leastAtBound()) {
    const FittedModel less = refitWithout(model_, *bound);
    model_ = refitWithDiscrepancy(less.effects, less);
    dropNeedless();
  }
}

}  // namespace darwinop::gap
