// Fits the baseline numbers, within their priors, to the residuals of one block: a few Gauss-Newton steps.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"
#include "gap/plant/block_residuals.hpp"

namespace darwinop::gap {

/// Removes from z of all logs what the numbers explain. Returns their moves in prior standard deviations.
Eigen::VectorXd fitNuisances(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                             const Hypothesis& hypothesis, const std::vector<Unknown>& numbers,
                             std::vector<BlockResiduals>& samples);

}  // namespace darwinop::gap
