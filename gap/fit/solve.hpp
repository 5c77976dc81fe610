// Maximum a posteriori fit of the unknowns: Levenberg-Marquardt with finite differences, and jumps out of local minima.
#pragma once

#include <Eigen/Core>

#include "gap/fit/problem.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {

struct Fit {
  Eigen::VectorXd x;            // search variables
  double cost = 0, prior = 0;   // as Problem::cost(); the prior's part of it
  Eigen::MatrixXd steps;        // of the finite differences, one column each; jacobian.hpp
  Eigen::VectorXd residuals;    // without the prior
  Eigen::MatrixXd jacobian;     // of the residuals by x, without the prior
  Eigen::MatrixXd information;  // matrix of x, priors included
  Eigen::MatrixXd covariance;   // its inverse; infinite for what the data do not determine
};

struct SolveOptions {
  int iterations = thresholds::kSolverIterations;
  bool refine = true;             // second pass along the eigenvectors; else no Jacobian and no covariance
  Eigen::MatrixXd steps = {};     // of the finite differences; empty: first steps
  Eigen::MatrixXd jacobian = {};  // at the start, by these steps; empty: not known
};

/// Starts at `start`, within the bounds; the result is never worse than that. From far off, large residuals count in
/// full at first, so that a swing that is out of phase comes back into phase.
Fit solve(const Problem& problem, const Eigen::VectorXd& start, const SolveOptions& options = {});

}  // namespace darwinop::gap
