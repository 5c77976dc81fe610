// The verdict of a finished selection; withdraws effects that fail on held-out logs.
#include <algorithm>
#include <functional>

#include "gap/identify/selection.hpp"
#include "gap/plant/position_error.hpp"

namespace darwinop::gap {

bool Selection::leavesNoise() const {
  return misfit_ < thresholds::kMisfitSigmas;
}

bool Selection::explainsAll() const {
  return leavesNoise() || (!model_.effects.empty() && isNearlyExact());
}

bool Selection::isConsistent() const {
  return explainsAll() && largestPriorSigma(model_) < thresholds::kPriorTensionSigmas;
}

// Another simulator, or a servo, never has exactly the same effect.
bool Selection::isNearlyExact() const {
  if (misfit_ > thresholds::kNearMisfitSigmas) return false;
  const double after = rmsPositionError(study_.plant, study_.data, model_.hypothesis(), LogRole::kFit);
  return after < thresholds::kNearFloors * floorOf(model_) && after < thresholds::kNearGapShare * study_.gap_rad;
}

// A third effect would be no finding either.
bool Selection::leavesMostOfTheGap() const {
  return model_.effects.size() > 1 && rmsPositionError(study_.plant, study_.data, model_.hypothesis(), LogRole::kFit) >
                                          thresholds::kHopelessGapShare * study_.gap_rad;
}

// False without held-out logs: comparisons with NaN.
bool Selection::worsensHeldOut(const Identification& found) const {
  const double before = meanPositionError(study_.plant, study_.data, study_.baseline, LogRole::kHeldOut);
  const double after = meanPositionError(study_.plant, study_.data, found.model, LogRole::kHeldOut);
  return after > thresholds::kHeldOutErrorRatio * before &&
         after > before + thresholds::kHeldOutFloors * found.floor_rad;
}

Identification Selection::result() const {
  Identification found;
  found.threshold = threshold_;
  found.misfit = misfit_;
  found.model = withoutUndetermined(model_);
  found.rivals = rivals_;
  found.prior_conflicts = priorConflictsOf(model_);
  const FittedModel free = withFreeNuisance(model_);
  const double cost = model_.fit.cost - model_.fit.prior, excess = cost / (cost - excess_cost_);
  for (std::size_t i = 0; i < model_.effects.size(); ++i) {
    const twin::EffectInfo& effect = *model_.effects[i].info;
    found.effects.push_back(
        {&effect, estimatesOf(free, effect, excess), gains_[i], study_.baseline.find(effect.id) != nullptr});
  }
  found.gap_before_rad = study_.gap_rad;
  found.gap_after_rad = rmsPositionError(study_.plant, study_.data, found.model, LogRole::kFit);
  found.floor_rad = floorOf(model_);
  const bool worsens = !found.effects.empty() && worsensHeldOut(found);
  found.verdict = worsens ? Verdict::kUnknown : verdictOf(found);
  // In `ambiguous` the last effect is the one with close rivals, so the order stays.
  if (found.verdict != Verdict::kAmbiguous)
    std::ranges::stable_sort(found.effects, std::greater{}, &IdentifiedEffect::gain);
  // If half of the gap has no name, there is little reason to trust the name of the other half.
  const bool half_left = found.gap_after_rad > thresholds::kHopelessGapShare * found.gap_before_rad;
  if (worsens || (found.verdict == Verdict::kUnknown && half_left)) withdraw(found, worsens);
  return found;
}

/// The baseline again, without additions.
void Selection::withdraw(Identification& found, bool worsens) const {
  for (const IdentifiedEffect& one : found.effects)
    if (worsens) found.rejected.push_back({one.effect, RejectionReason::kWorsensHeldOut});
  const FittedModel nothing = Selection{study_, options_, Nuisance::kFixed}.model();
  found.misfit = misfitOf(nothing, bootstrapOf(nothing, nullptr, thresholds::kBootstrapRuns));
  found.effects.clear();
  found.rivals.clear();
  found.prior_conflicts.clear();
  found.model = study_.baseline;
  found.gap_after_rad = found.gap_before_rad;
}

}  // namespace darwinop::gap
