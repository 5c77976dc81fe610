// The next effect of floor, trunk or moving sensor: starts, fits and evidence of all names.
#pragma once

#include <vector>

#include "gap/identify/body/floor_fit.hpp"

namespace darwinop::gap {

struct FloorCandidate {
  FloorFit fit;              // of all effects found, and of one more
  double start_cost = 0;     // of the best start
  double evidence = 0;       // gain of the cost less the prices of numbers and name: against rivals
  double name_evidence = 0;  // the same, but gains no more than what engines differ by costs: against no effect
};

/// Every effect that was not found yet, best by evidence first. `base_cost`: of `found` alone.
std::vector<FloorCandidate> nextFloorEffects(FloorEvaluator& evaluator, const std::vector<const FloorEffect*>& effects,
                                             const FloorSet& found, double base_cost);

/// A number is no better known than equally good fits differ: of about the cost of the best.
void widenByEqualFits(FloorFit& best, const std::vector<FloorFit>& fits);

/// The best of fits from here and from both sides, under the noise of what was found: its chaos is another than that of
/// the model without. Equally good fits widen the intervals.
FloorFit refined(FloorEvaluator& evaluator, const FloorSet& found);

/// The last effect of `set` at other strengths, all of its numbers together and its first vector alone: each is
/// simulated.
std::vector<FloorSet> variationsOf(const FloorSet& set);

}  // namespace darwinop::gap
