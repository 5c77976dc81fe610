#include "gap/identify/rough_selection.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <utility>

#include "gap/identify/assessment.hpp"
#include "gap/identify/held_out.hpp"
#include "gap/identify/jackknife.hpp"
#include "gap/identify/rivals.hpp"
#include "gap/identify/shortlist.hpp"
#include "gap/identify/supply_check.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "gap/plant/position_error.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {
namespace {

/// Of what every servo has, two standard errors are enough; a rarer effect has rivals that predict better by chance.
bool isConfirmed(const twin::EffectInfo& effect, const CrossValidation& validation) {
  return isCommon(effect) ? validation.improves() : validation.improvesBy(thresholds::kRareEffectHelp);
}

/// It stands for numbers that the owner has weighed or measured.
bool isOfTheBench(const twin::EffectInfo& effect) {
  return isAliasOf(effect, "payload") || isAliasOf(effect, "length");
}

}  // namespace

void RoughSelection::run() {
  addCommonEffects();
  for (int i = 0; i < thresholds::kMaxRareEffects && addRareEffect(); ++i) {
  }
  dropUncertain();
  noteDoubles();
}

std::string_view RoughSelection::replacedBy(const FittedModel& candidate) const {
  for (const ChosenEffect& effect : model_.effects)
    if (!has(candidate.effects, *effect.info)) return effect.info->id;
  return "";
}

void RoughSelection::reportPrediction(const twin::EffectInfo& effect, const CrossValidation& validation) const {
  char text[160];
  std::snprintf(text, sizeof text, "%s: prediction error ratio %.2f, %.2f to %.2f", std::string{effect.id}.c_str(),
                std::exp(validation.mean), std::exp(validation.mean - 2 * validation.error),
                std::exp(validation.mean + 2 * validation.error));
  options_.progress(text);
}

// Where the fitted logs disagree whether a load mass or length is wrong, the owner's measurement counts: in a folder of
// 960 logs whose loads were right, a load mass error stood for friction and improved predictions.
std::vector<RoughSelection::Tested> RoughSelection::testRareEffects(std::vector<FittedModel>& candidates) {
  std::vector<Tested> helping;
  std::size_t tested = 0;
  rejected_.clear();
  for (FittedModel& candidate : candidates) {
    const twin::EffectInfo& effect = *candidate.effects.back().info;
    if (model_.fit.cost - candidate.fit.cost < thresholds::kRareEffectGain ||
        (!validationSuffices() && tested == thresholds::kCrossValidatedEffects))
      continue;
    if (isAtItsBound(candidate, effect)) continue;
    if (contradictsVoltage(candidate)) {
      rejected_.push_back({&effect, RejectionReason::kVoltage});
      continue;
    }
    ++tested;
    candidate = refitUnderNoiseOf(candidate, model_, true);
    std::vector<double> with = errorsOf(candidate);
    const CrossValidation validation = crossValidate(errors_, with, floor_rad_);
    reportPrediction(effect, validation);
    const bool helps = validation.mean >= thresholds::kRareEffectHelp;
    const bool is_measured = isOfTheBench(effect) && mayBeNone(candidate, candidate.effects.back());
    if (!helps || is_measured || !isConfirmed(effect, validation))
      rejected_.push_back({&effect, helps ? RejectionReason::kUndecided : RejectionReason::kNoPredictiveGain});
    if (helps && !is_measured) helping.push_back({&candidate, validation, std::move(with), replacedBy(candidate)});
  }
  std::ranges::stable_sort(rejected_, {}, &RejectedEffect::why);
  return helping;
}

// What some logs ask for and others refuse is decided by logs that are not there: full duty, another gain.
void RoughSelection::noteRivals(const std::vector<Tested>& tested, const Tested* best) {
  std::vector<std::string_view> again;
  for (const Tested& one : tested) again.push_back(one.model->effects.back().info->id);
  carryOn(rivals_, again, best == nullptr ? "" : best->model->effects.back().info->id);
  if (best != nullptr && !best->replaced.empty())  // a richer form stands in its place, also in theirs
    for (Rival& rival : rivals_) std::erase(rival.effects, best->replaced);
  for (const Tested& other : tested) {
    if (&other == best || other.refused ||
        (best != nullptr && crossValidate(other.errors, best->errors, floor_rad_).improves()))
      continue;
    const Effects& effects = other.model->effects;
    rivals_.push_back({idsOf(best == nullptr ? effects : neededOf(*other.model, best->model->effects)), 0, false});
  }
}

// A rival is to differ from what was found by what decides, not by a friction that matters to neither.
Effects RoughSelection::neededOf(const FittedModel& rival, const Effects& offered) const {
  std::optional<FittedModel> refitted;
  Effects needed;
  for (std::size_t i = 0; i < rival.effects.size(); ++i) {
    const ChosenEffect& effect = rival.effects[i];
    const bool was_dropped = has(offered, *effect.info) && !has(model_.effects, *effect.info);
    if (was_dropped && !refitted) refitted = refitWithDiscrepancy(rival.effects, rival);
    if (!was_dropped || !isNeedless(*effect.info, *refitted, refitWithout(*refitted, i))) needed.push_back(effect);
  }
  return needed;
}

/// The held-out logs contradict the fitted ones: then neither decides.
bool RoughSelection::worsensHeldOut(const FittedModel& with) const {
  const auto error = [&](const FittedModel& fitted) {
    return meanPositionError(study_.plant, study_.data, fitted.hypothesis(), LogRole::kHeldOut);
  };
  return isWorse(error(model_), error(with), floorOf(study_.evidence));
}

// With one gain and no load column a scale of all torques is free: a scale of the gain moved the one friction of a
// joint to the end of its range, and without that friction nothing was left that explained its logs.
bool RoughSelection::accept(FittedModel with) {
  const std::size_t effects = with.effects.size();
  FittedModel before = std::exchange(model_, std::move(with));
  dropNeedless();
  dropAtBounds();
  std::vector<double> errors = errorsOf(model_);
  const bool helps = model_.effects.size() == effects || crossValidate(errors_, errors, floor_rad_).improves();
  if (helps)
    errors_ = std::move(errors);
  else
    model_ = std::move(before);
  return helps;
}

bool RoughSelection::addRareEffect() {
  std::vector<FittedModel> candidates = richerForms();
  for (FittedModel& beside : shortlist(model_, Screen{model_, candidates_}, true))
    if (std::ranges::none_of(candidates,
                             [&](const FittedModel& form) { return has(form.effects, *beside.effects.back().info); }))
      candidates.push_back(std::move(beside));
  std::vector<Tested> helping = testRareEffects(candidates);
  std::ranges::stable_sort(helping, std::greater{}, [](const Tested& one) { return one.validation.mean; });
  for (Tested& one : helping) {
    const twin::EffectInfo& added = *one.model->effects.back().info;
    if (!isConfirmed(added, one.validation) || worsensHeldOut(*one.model)) continue;
    FittedModel with = refitWithDiscrepancy(one.model->effects, *one.model);
    one.refused = isAtItsBound(with, added) || !accept(std::move(with));
    if (one.refused) continue;
    if (has(model_.effects, added)) noteRivals(helping, &one);
    return true;
  }
  noteRivals(helping, nullptr);
  return false;
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
  if ((found.remains || !found.effects.empty()) && gap::worsensHeldOut(study_, found.model, found.floor_rad))
    withdraw(study_, true, found);
  // No effect could have been named, whatever the logs contain.
  if (found.verdict == Verdict::kUnknown && std::ssize(errors_) < CrossValidation::kFewestLogs) {
    if (!found.effects.empty()) withdraw(study_, false, found);
    found.verdict = Verdict::kCannotTell, found.too_few_logs = true;
  }
  return found;
}

}  // namespace darwinop::gap
