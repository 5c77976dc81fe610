// Small dense nonlinear least squares (Gauss-Newton with Levenberg's damping) for a handful of unknowns.
#pragma once

#include <functional>
#include <vector>

namespace darwinop::calibrate {

struct LeastSquares {
  std::vector<double> values, sigmas;  // sigmas: for residuals of unit variance
  double cost = 0;                     // sum of squared residuals
};

/// Residuals of the unknowns; the priors are residuals also, so that the problem is never singular.
using Residuals = std::function<std::vector<double>(const std::vector<double>&)>;

/// `steps`: of the numeric Jacobian, in the unit of each unknown.
LeastSquares leastSquares(const Residuals& residuals, std::vector<double> start, const std::vector<double>& steps);

}  // namespace darwinop::calibrate
