// Levenberg-Marquardt, by Ceres.
#pragma once

#include "gap/fit/problem.hpp"

namespace darwinop::gap {

/// Slope of the search variable's distance to its prior, in sigmas; 0: it has none.
double priorWeight(const Unknown& unknown, double x);

/// `x`, moved to where Problem::cost() is least, in so many steps. `steps`: of the difference quotients. `width`:
/// beyond so many sigma a residual counts linearly; thresholds::kRobustSigmas is what Problem::cost() has.
Eigen::VectorXd searched(const Problem& problem, Eigen::VectorXd x, const Eigen::MatrixXd& steps, int iterations,
                         double width);

}  // namespace darwinop::gap
