// Moves the numbers of a model inside their priors to where a cut has least left: a small search, by a few steps of
// linear algebra.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"
#include "gap/plant/bench/block_residuals.hpp"

namespace darwinop::gap {

/// Takes from z of all logs together what the numbers explain; returns how far they moved, in sigmas of their priors.
Eigen::VectorXd fitNuisances(const BlockResidualFunction& cut, const Case& given, const std::vector<std::size_t>& logs,
                             const Hypothesis& hypothesis, const std::vector<Unknown>& numbers,
                             std::vector<BlockResiduals>& samples);

}  // namespace darwinop::gap
