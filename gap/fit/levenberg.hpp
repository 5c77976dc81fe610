// Levenberg-Marquardt least squares, by Ceres.
#pragma once

#include "gap/fit/problem.hpp"

namespace darwinop::gap {

/// Derivative of the prior residual by the search variable, in standard deviations; 0: no prior.
double priorWeight(const Unknown& unknown, double x);

struct Searched {
  Eigen::VectorXd x;
  Eigen::MatrixXd jacobian;  // jacobianAt(x); empty if the search took none there
};

/// Minimises Problem::cost() from `x`. `steps`: of the finite differences. `width`: standard deviations beyond which a
/// residual counts linearly; Problem::cost() has thresholds::kRobustSigmas.
Searched searched(const Problem& problem, Eigen::VectorXd x, const Eigen::MatrixXd& steps, int iterations,
                  double width);

}  // namespace darwinop::gap
