// Where the fit of an effect of floor, trunk or moving sensor begins.
#pragma once

#include "gap/identify/body/floor_fit.hpp"

namespace darwinop::gap {

struct FloorStart {
  FloorSet set;  // what was found, and the effect
  double cost = 0;
};

/// The best of an effect's starts, on top of what was found. Of a linear effect: of the solutions for all logs
/// together, and for each log that such a solution mostly explains.
FloorStart bestStart(FloorEvaluator& evaluator, const FloorSet& found, const FloorEffect& effect);

}  // namespace darwinop::gap
