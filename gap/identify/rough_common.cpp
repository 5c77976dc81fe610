// Effects that every servo has, fitted together from several starts; what is needless or at the end of its range is
// refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gap/case/log_traits.hpp"
#include "gap/identify/assessment.hpp"
#include "gap/identify/jackknife.hpp"
#include "gap/identify/rough_selection.hpp"
#include "gap/plant/position_error.hpp"
#include "gap/plant/registers.hpp"

namespace darwinop::gap {
namespace {

bool isCommon(const twin::EffectInfo& effect) {
  return effect.prevalence == twin::Prevalence::kCommon;
}

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

/// Repeats of a motion on the same bench share what the model lacks, and would count as several witnesses: one of each
/// motion, of those that are neither fitted nor held out.
Case unusedLogsOf(Case given) {
  std::vector<LogTraits> known;
  for (const Trajectory& log : given.logs) known.push_back(traitsOf(log));
  std::vector<Trajectory> unused;
  for (const Trajectory& log : given.others) {
    const LogTraits traits = traitsOf(log);
    if (std::ranges::find(known, traits) != known.end()) continue;
    known.push_back(traits);
    unused.push_back(log);
  }
  given.logs = std::move(unused);
  given.others.clear();
  return given;
}

/// The model without the effect is inside the intervals of this one, by how far the logs disagree.
bool mayBeNone(const FittedModel& fitted, const ChosenEffect& effect) {
  const std::optional<Eigen::VectorXd> half_widths = halfWidthsByLogs(fitted);
  if (!half_widths) return false;
  const Eigen::VectorXd off = (fitted.fit.x - takenOut(fitted, effect, fitted.fit.x)).cwiseAbs();
  return (off.array() <= half_widths->array()).all();
}

}  // namespace

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
      unused_{unusedLogsOf(study.data)},
      floor_rad_{readingSigma(study.data.model.servo)},
      candidates_{candidateEffectsOf(study.data)},
      model_{
          refitWithDiscrepancy(from.effects, refitWithDiscrepancy(study, from.effects, restarted(from.effects, from)))},
      errors_{errorsOf(model_)} {}

bool RoughSelection::validatesOnUnused() const {
  const std::size_t fitted = independentLogs(study_.evidence).size();
  return unused_.logs.size() >= std::max<std::size_t>(CrossValidation::kFewestLogs, fitted);
}

std::vector<double> RoughSelection::errorsOf(const FittedModel& fitted) const {
  std::vector<double> errors = predictionErrors(study_.plant, unused_, fitted.hypothesis());
  if (validatesOnUnused()) return errors;
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
