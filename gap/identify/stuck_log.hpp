// A way past a log in which the arm stays stuck in the model and not in the measurement, or the other way round: no
// gradient frees it, and on the way to where it is free its error grows, so that it holds back what the other logs ask
// for.
#pragma once

#include <optional>

#include "gap/identify/fitted_model.hpp"

namespace darwinop::gap {

/// The same effects, fitted from the optimum of the other logs, if `fitted` is plainly wrong (thresholds::kPlainCost)
/// in one motion only, a log or its repeats. Nothing: it is not, or that fit is no better.
std::optional<FittedModel> fittedPastAStuckLog(const FittedModel& fitted);

}  // namespace darwinop::gap
