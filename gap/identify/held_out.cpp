#include "gap/identify/held_out.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include "gap/identify/assessment.hpp"
#include "gap/plant/position_error.hpp"

namespace darwinop::gap {
namespace {

double heldOutError(const Study& study, const Hypothesis& model) {
  return rmsPositionError(study.plant, study.data, model, LogRole::kHeldOut);
}

/// Rms position error that noise alone produces on the held-out logs, rad. NaN: there are none.
double heldOutFloor(const FittedModel& fitted) {
  return floorOf(evidenceOf(fitted.study->plant, fitted.study->data, fitted.hypothesis(), LogRole::kHeldOut));
}

}  // namespace

bool worsensHeldOut(const Study& study, const Hypothesis& model, double floor_rad) {
  const auto grows = [&](auto error) {
    const double before = error(study.plant, study.data, study.baseline, LogRole::kHeldOut);
    const double after = error(study.plant, study.data, model, LogRole::kHeldOut);
    return isWorse(before, after, floor_rad);
  };
  return grows(&rmsPositionError) || grows(&meanPositionError);
}

bool predictsHeldOut(const FittedModel& fitted) {
  const Study& study = *fitted.study;
  const FittedModel free = withFreeNuisance(fitted);
  const double after = heldOutError(study, fitted.hypothesis()),
               most = thresholds::kLeastGapFloors * heldOutFloor(fitted);
  if (fitted.effects.empty() || !(after < most)) return false;
  for (std::size_t i = 0; i < fitted.effects.size(); ++i) {
    const double without_it = heldOutError(study, modelWithout(free, i));
    if (without_it < most || without_it < thresholds::kHeldOutHelp * after) return false;
  }
  return true;
}

void withdraw(const Study& study, bool worsens, Identification& found) {
  std::vector<RejectedEffect> worsening;
  for (const IdentifiedEffect& one : found.effects)
    if (worsens) worsening.push_back({one.effect, RejectionReason::kWorsensHeldOut});
  found.rejected.insert(found.rejected.begin(), worsening.begin(), worsening.end());
  const FittedModel nothing = baselineAlone(study, Nuisance::kFixed);
  found.misfit = misfitOf(nothing, bootstrapOf(nothing, nullptr, thresholds::kBootstrapRuns));
  found.verdict = Verdict::kUnknown;
  found.remains = false;
  found.withdrawn = std::exchange(found.effects, {});
  found.rivals.clear();
  found.prior_conflicts.clear();
  found.model = study.baseline;
  found.gap_after_rad = found.gap_before_rad;
}

}  // namespace darwinop::gap
