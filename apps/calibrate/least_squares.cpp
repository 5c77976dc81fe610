#include "apps/calibrate/least_squares.hpp"

#include <cmath>
#include <stdexcept>

namespace darwinop::calibrate {
namespace {

using Vector = std::vector<double>;
using Matrix = std::vector<Vector>;  // rows

double squares(const Vector& v) {
  double sum = 0;
  for (const double value : v) sum += value * value;
  return sum;
}

/// Central differences; one row per unknown.
Matrix jacobian(const Residuals& residuals, const Vector& at, const Vector& steps) {
  Matrix out;
  for (std::size_t i = 0; i < at.size(); ++i) {
    Vector low = at, high = at;
    low[i] -= steps[i], high[i] += steps[i];
    Vector slope = residuals(high);
    const Vector below = residuals(low);
    for (std::size_t k = 0; k < slope.size(); ++k) slope[k] = (slope[k] - below[k]) / (2 * steps[i]);
    out.push_back(std::move(slope));
  }
  return out;
}

double dot(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

/// Lower Cholesky factor. The priors keep the matrix positive definite.
Matrix cholesky(Matrix a) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      for (std::size_t j = 0; j < k; ++j) a[i][k] -= a[i][j] * a[k][j];
      if (i > k) a[i][k] /= a[k][k];
    }
    if (!(a[i][i] > 0)) throw std::logic_error("least squares without a prior for every unknown");
    a[i][i] = std::sqrt(a[i][i]);
  }
  return a;
}

Vector solve(const Matrix& factor, Vector b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= factor[i][k] * b[k];
    b[i] /= factor[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= factor[k][i] * b[k];
    b[i] /= factor[i][i];
  }
  return b;
}

Matrix normalEquations(const Matrix& slopes) {
  Matrix a(slopes.size(), Vector(slopes.size()));
  for (std::size_t i = 0; i < slopes.size(); ++i)
    for (std::size_t k = 0; k < slopes.size(); ++k) a[i][k] = dot(slopes[i], slopes[k]);
  return a;
}

}  // namespace

LeastSquares leastSquares(const Residuals& residuals, std::vector<double> start, const std::vector<double>& steps) {
  constexpr int kMostIterations = 50;
  constexpr double kConverged = 1e-9;  // relative decrease of the cost
  LeastSquares fit{.values = std::move(start), .sigmas = {}, .cost = 0};
  Vector now = residuals(fit.values);
  fit.cost = squares(now);
  double damping = 1e-6;
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    const Matrix slopes = jacobian(residuals, fit.values, steps);
    Matrix a = normalEquations(slopes);
    for (std::size_t i = 0; i < a.size(); ++i) a[i][i] *= 1 + damping;
    Vector gradient;
    for (const Vector& slope : slopes) gradient.push_back(-dot(slope, now));
    const Vector step = solve(cholesky(std::move(a)), gradient);
    Vector next = fit.values;
    for (std::size_t i = 0; i < next.size(); ++i) next[i] += step[i];
    Vector there = residuals(next);
    const double cost = squares(there);
    if (!(cost < fit.cost)) {
      damping *= 10;
      if (damping > 1e6) break;
      continue;
    }
    const bool converged = fit.cost - cost < kConverged * (1 + cost);
    fit.values = std::move(next), now = std::move(there), fit.cost = cost;
    damping /= 10;
    if (converged) break;
  }
  const Matrix factor = cholesky(normalEquations(jacobian(residuals, fit.values, steps)));
  for (std::size_t i = 0; i < fit.values.size(); ++i) {
    Vector unit(fit.values.size());
    unit[i] = 1;
    fit.sigmas.push_back(std::sqrt(solve(factor, unit)[i]));
  }
  return fit;
}

}  // namespace darwinop::calibrate
