// Slopes of the residuals by difference quotients, along directions of one's choice.
//
// Torque constant, resistance, payload and length trade against each other: what remains when all move together is a
// thousandth of what each does alone, and is lost in the curvature of the steps. So a second look steps along the
// directions that the data see as independent, as far as they resolve each.
#pragma once

#include "gap/fit/problem.hpp"

namespace darwinop::gap {

/// Columns: steps of the search variables. One unknown each, of the size for a first look.
Eigen::MatrixXd firstSteps(const Problem& problem);
/// Along the axes of the ellipsoid that `information` describes, one standard deviation each, but no longer than twice
/// the first steps.
Eigen::MatrixXd stepsAlong(const Problem& problem, const Eigen::MatrixXd& information);

/// Of the residuals by the search variables, a column an unknown. `residuals`: at `x`.
Eigen::MatrixXd jacobianAt(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                           const Eigen::MatrixXd& steps);

}  // namespace darwinop::gap
