// Jacobian of the residuals by finite differences along chosen directions.
//
// Torque constant, resistance, payload and length compensate each other: moved together they change the residuals a
// thousand times less than alone, which curvature hides. So the second pass steps along the eigenvectors of the
// information matrix, one standard deviation each.
#pragma once

#include "gap/fit/problem.hpp"

namespace darwinop::gap {

/// Columns: steps of the search variables. One unknown each, of the size for a first pass.
Eigen::MatrixXd firstSteps(const Problem& problem);
/// Along the axes of the ellipsoid that `information` describes, one standard deviation each, but no longer than twice
/// the first steps.
Eigen::MatrixXd stepsAlong(const Problem& problem, const Eigen::MatrixXd& information);

/// Derivatives of the residuals by the search variables, one column for each unknown. `residuals`: at `x`.
Eigen::MatrixXd jacobianAt(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                           const Eigen::MatrixXd& steps);

}  // namespace darwinop::gap
