#include "gap/identify/rough_selection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <utility>

#include "gap/identify/assessment.hpp"
#include "gap/identify/held_out.hpp"
#include "gap/identify/shortlist.hpp"
#include "gap/identify/supply_check.hpp"
#include "gap/plant/position_error.hpp"
#include "twin/effects/catalogue.hpp"

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

/// `effects` with all numbers free; what `from` leaves counts as noise.
FittedModel refitWithDiscrepancy(const Effects& effects, const FittedModel& from) {
  Evidence evidence{.plant = from.evidence->plant,
                    .given = from.evidence->given,
                    .logs = from.evidence->logs,
                    .noise = {},
                    .discrepancy = {}};
  evidence.discrepancy = discrepancyOf(*evidence.plant, *evidence.given, evidence.logs, from.hypothesis());
  return refit(*from.study, effects, Nuisance::kFree, {evidence, from.problem.hypothesis(), from.problem.unknowns()},
               from.fit, 2);
}

}  // namespace

RoughSelection::RoughSelection(const Study& study, const IdentifyOptions& options, const Effects& effects,
                               const FittedModel& from)
    : study_{study},
      options_{options},
      candidates_{candidateEffectsOf(study.data)},
      model_{refitWithDiscrepancy(effects, refitWithDiscrepancy(effects, restarted(effects, from)))} {}

void RoughSelection::run() {
  addCommonEffects();
  for (int i = 0; i < thresholds::kMaxRareEffects && addRareEffect(); ++i) {
  }
}

void RoughSelection::addCommonEffects() {
  options_.progress("effects that every servo has: friction of three kinds, encoder offset");
  const std::vector<double> before = leaveOneOutErrors(model_);
  const FittedModel bare = model_;
  Effects common = model_.effects;
  for (const twin::EffectInfo* const effect : candidates_)
    if (isCommon(*effect) && !has(common, *effect)) common.push_back({effect});
  double least = std::numeric_limits<double>::infinity();
  for (const Start& start : kStarts) {
    // The second refit has less discrepancy to accept as noise.
    const FittedModel first = refitWithDiscrepancy(common, startedAt(start, restarted(common, bare)));
    FittedModel second = refitWithDiscrepancy(common, first);
    const double error = meanPositionError(study_.plant, study_.data, second.hypothesis(), LogRole::kFit);
    if (error < least) least = error, model_ = std::move(second);
  }
  dropNeedless();
  if (!crossValidate(before, leaveOneOutErrors(model_)).improves()) model_ = bare;
}

std::vector<RoughSelection::Tested> RoughSelection::testRareEffects(const std::vector<FittedModel>& candidates) {
  const std::vector<double> errors = leaveOneOutErrors(model_);
  std::vector<Tested> improving;
  std::size_t tested = 0;
  rejected_.clear();
  for (const FittedModel& candidate : candidates) {
    const twin::EffectInfo& effect = *candidate.effects.back().info;
    if (model_.fit.cost - candidate.fit.cost < thresholds::kRareEffectGain ||
        tested == thresholds::kCrossValidatedEffects)
      continue;
    if (isAtItsBound(candidate, effect)) continue;
    if (contradictsVoltage(candidate)) {
      rejected_.push_back({&effect, RejectionReason::kVoltage});
      continue;
    }
    ++tested;
    const CrossValidation validation = crossValidate(errors, leaveOneOutErrors(candidate));
    char text[160];
    std::snprintf(text, sizeof text, "%s: leave-one-log-out prediction error ratio %.2f, %.2f to %.2f",
                  std::string{effect.id}.c_str(), std::exp(validation.mean),
                  std::exp(validation.mean - 2 * validation.error), std::exp(validation.mean + 2 * validation.error));
    options_.progress(text);
    const bool helps = validation.mean >= thresholds::kRareEffectHelp;
    if (validation.improves() && helps)
      improving.push_back({&candidate, validation});
    else
      rejected_.push_back({&effect, helps ? RejectionReason::kUndecided : RejectionReason::kNoPredictiveGain});
  }
  std::ranges::stable_sort(rejected_, {}, &RejectedEffect::why);
  return improving;
}

bool RoughSelection::addRareEffect() {
  const std::vector<FittedModel> candidates = shortlist(model_, Screen{model_, candidates_});
  const std::vector<Tested> improving = testRareEffects(candidates);
  if (improving.empty()) return false;
  const FittedModel* const best =
      std::ranges::max_element(improving, {}, [](const Tested& one) { return one.validation.mean; })->model;
  for (const Tested& other : improving)
    if (other.model != best)
      rivals_.push_back({idsOf(other.model->effects), std::max(0.0, modelEvidence(*best) - modelEvidence(*other.model)),
                         other.model->problem.unknowns().size() > best->problem.unknowns().size()});
  model_ = refitWithDiscrepancy(best->effects, *best);
  dropNeedless();
  if (!has(model_.effects, *best->effects.back().info)) rivals_.clear();  // of an effect that is gone
  return true;
}

void RoughSelection::dropNeedless() {
  for (std::size_t i = 0; i < model_.effects.size();) {
    const double needed =
        isCommon(*model_.effects[i].info) ? thresholds::kCommonEffectGain : thresholds::kRareEffectGain;
    const FittedModel less = refitWithout(model_, i);
    if (less.fit.cost - model_.fit.cost < needed)
      model_ = refitWithDiscrepancy(less.effects, less);
    else
      ++i;
  }
}

bool RoughSelection::hasAll(const std::vector<std::string>& effects) const {
  return std::ranges::all_of(effects,
                             [&](const std::string& id) { return has(model_.effects, *twin::findEffect(id)); });
}

Verdict RoughSelection::verdictWithRemainder(const Identification& found) const {
  const double before = meanPositionError(study_.plant, study_.data, study_.baseline, LogRole::kFit);
  const double after = meanPositionError(study_.plant, study_.data, found.model, LogRole::kFit);
  return verdictOfRough(found, before, after);
}

Identification RoughSelection::result() const {
  Identification found;
  found.model = model_.hypothesis();
  found.prior_conflicts = priorConflictsOf(model_);
  found.threshold = std::numeric_limits<double>::quiet_NaN();  // selected by prediction, not by chance gain
  found.rejected = rejected_;
  for (std::size_t i = 0; i < model_.effects.size(); ++i) {
    const twin::EffectInfo& effect = *model_.effects[i].info;
    found.effects.push_back({&effect, estimatesOf(model_, effect, 1),
                             refitWithout(model_, i).fit.cost - model_.fit.cost,
                             study_.baseline.find(effect.id) != nullptr});
  }
  std::ranges::copy_if(rivals_, std::back_inserter(found.rivals),
                       [&](const Rival& rival) { return !hasAll(rival.effects); });
  const FittedModel exactly = evaluateUnderOwnNoise(model_);
  found.misfit = misfitOf(exactly, bootstrapOf(exactly, nullptr, thresholds::kBootstrapRuns));
  found.floor_rad = floorOf(exactly);
  found.gap_before_rad = study_.gap_rad;
  found.gap_after_rad = rmsPositionError(study_.plant, study_.data, found.model, LogRole::kFit);
  found.remains = found.misfit > thresholds::kMisfitSigmas;
  found.verdict = found.remains ? verdictWithRemainder(found) : verdictOf(found);
  if ((found.remains || !found.effects.empty()) && worsensHeldOut(study_, found.model, found.floor_rad))
    withdraw(study_, true, found);
  return found;
}

}  // namespace darwinop::gap
