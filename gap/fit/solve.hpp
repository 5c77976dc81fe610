// Finds the unknowns that fit best: Levenberg-Marquardt by Ceres, with derivatives from simulation.
#pragma once

#include <Eigen/Core>

#include "gap/fit/problem.hpp"

namespace darwinop::gap {

struct Fit {
  Eigen::VectorXd x;            // search variables
  double cost = 0, prior = 0;   // as Problem::cost(); its part that is the prior's
  Eigen::MatrixXd steps;        // of the difference quotients, a column each; slopes.hpp
  Eigen::VectorXd residuals;    // without the prior
  Eigen::MatrixXd jacobian;     // of the residuals by x, without the prior
  Eigen::MatrixXd information;  // of x, the priors' included
  Eigen::MatrixXd covariance;   // its inverse; infinite where the data say nothing
};

struct SolveOptions {
  int iterations = 12;
  bool refine = true;          // once more, along what the data resolve; else no slopes and no covariance
  Eigen::MatrixXd steps = {};  // of the difference quotients; empty: those that suit a first look
};

/// Begins at `start`; never ends worse. From far off, large residuals count in full at first: a swing that is out of
/// phase has to be pulled back into it.
Fit solve(const Problem& problem, const Eigen::VectorXd& start, const SolveOptions& options = {});

}  // namespace darwinop::gap
