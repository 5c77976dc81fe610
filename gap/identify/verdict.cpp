// The verdict of a finished selection.
#include <algorithm>
#include <functional>

#include "gap/identify/held_out.hpp"
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

Identification Selection::result() const {
  Identification found;
  found.threshold = threshold_;
  found.misfit = misfit_;
  found.model = withoutUndetermined(model_);
  found.rivals = rivals_;
  found.prior_conflicts = priorConflictsOf(model_);
  const FittedModel free = withFreeNuisance(model_);
  const double cost = model_.fit.cost - model_.fit.prior;
  const double least = explainsAll() ? 1 : 1.01 * thresholds::kRightCostRatio;  // a remainder widens every interval
  const double excess = std::max(least, cost / (cost - excess_cost_));
  for (std::size_t i = 0; i < model_.effects.size(); ++i) {
    const twin::EffectInfo& effect = *model_.effects[i].info;
    found.effects.push_back(
        {&effect, estimatesOf(free, effect, excess), gains_[i], study_.baseline.find(effect.id) != nullptr});
  }
  found.gap_before_rad = study_.gap_rad;
  found.gap_after_rad = rmsPositionError(study_.plant, study_.data, found.model, LogRole::kFit);
  found.floor_rad = floorOf(model_);
  found.verdict = verdictOf(found);
  // A remainder that is small on logs that no fit has seen takes no name away.
  if (found.verdict == Verdict::kUnknown && predictsHeldOut(model_)) found.verdict = namedOrAmbiguous(found);
  const bool accepted = found.verdict == Verdict::kNamed || found.verdict == Verdict::kAmbiguous;
  found.remains = accepted && !explainsAll();
  if (found.verdict == Verdict::kUnknown) found.rejected = rejected_;
  // In `ambiguous` the last effect is the one with close rivals, so the order stays.
  if (found.verdict != Verdict::kAmbiguous)
    std::ranges::stable_sort(found.effects, std::greater{}, &IdentifiedEffect::gain);
  // If half of the gap has no name, there is little reason to trust the name of the other half.
  const bool half_left =
      found.verdict == Verdict::kUnknown && found.gap_after_rad > thresholds::kHopelessGapShare * found.gap_before_rad;
  const bool worsens = !found.effects.empty() && worsensHeldOut(study_, found.model, found.floor_rad);
  if (worsens || half_left) withdraw(study_, worsens, found);
  return found;
}

}  // namespace darwinop::gap
