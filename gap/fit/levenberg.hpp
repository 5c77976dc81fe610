// Levenberg-Marquardt least squares, by Ceres.
#pragma once

#include "gap/fit/problem.hpp"

namespace darwinop::gap {

/// Derivative of the prior residual by the search variable, in standard deviations; 0: no prior.
double priorWeight(const Unknown& unknown, double x);

struct Searched {
  Eigen::VectorXd x;
  Eigen::MatrixXd jacobian;  // jacobianAt(x); empty if it is not known
};

/// Minimises Problem::cost() from a point, whose Jacobian is not taken again. `steps`: of the finite differences.
/// `width`: standard deviations beyond which a residual counts linearly; Problem::cost() has thresholds::kRobustSigmas.
Searched searched(const Problem& problem, Searched from, const Eigen::MatrixXd& steps, int iterations, double width);

}  // namespace darwinop::gap
