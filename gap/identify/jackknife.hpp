// How well a fit determines its unknowns, judged by how far the logs disagree.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "gap/identify/fitted_model.hpp"

namespace darwinop::gap {

/// Half widths of 90 % intervals of the unknowns, search variables; infinite for what one log alone shows. None with
/// fewer than CrossValidation::kFewestLogs independent logs, or without a Jacobian.
std::optional<Eigen::VectorXd> halfWidthsByLogs(const FittedModel& fitted);
/// The model without the effect is inside these intervals.
bool mayBeNone(const FittedModel& fitted, const ChosenEffect& effect);

}  // namespace darwinop::gap
