#include "gap/fit/levenberg.hpp"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>

#include "gap/fit/jacobian.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Pseudo-Huber's signed root.
double rootOfCost(double residual, double width) {
  const double share = residual / width;
  return std::copysign(width * std::sqrt(2 * (std::sqrt(1 + share * share) - 1)), residual);
}

/// All residuals, each as the root of its cost, so that a plain sum of squares is robust; then the priors.
class RobustCost final : public ceres::CostFunction {
 public:
  RobustCost(const Problem& problem, const Searched& from, Eigen::MatrixXd steps, double width)
      : problem_{problem}, steps_{std::move(steps)}, width_{width} {
    if (from.jacobian.size() != 0) jacobian_at_ = from.x, jacobian_ = from.jacobian;
    const int unknowns = static_cast<int>(problem.unknowns().size());
    set_num_residuals(static_cast<int>(problem.evidence().size()) + unknowns);
    mutable_parameter_block_sizes()->push_back(unknowns);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Index rows = problem_.evidence().size(), unknowns = steps_.cols();
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], unknowns);
    const Eigen::VectorXd& plain = residualsAt(x);
    Eigen::Map<Eigen::VectorXd> out{residuals, rows + unknowns};
    out.head(rows) = plain.unaryExpr([this](double r) { return rootOfCost(r, width_); });
    for (Eigen::Index i = 0; i < unknowns; ++i) {
      const Unknown& unknown = problem_.unknowns()[static_cast<std::size_t>(i)];
      const double sigma = unknown.sigma;
      out[rows + i] = std::isfinite(sigma) ? (unknown.fromSearch(x[i]) - unknown.expected) / sigma : 0;
    }
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;

    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> jacobian{jacobians[0], rows + unknowns, unknowns};
    jacobian.setZero();
    const Eigen::VectorXd chain = plain.binaryExpr(out.head(rows), [this](double r, double root) {
      return root == 0 ? 1 : r / (root * std::sqrt(1 + r * r / (width_ * width_)));
    });
    if (!isKnownAt(x)) {
      jacobian_ = jacobianAt(problem_, x, plain, steps_);
      jacobian_at_ = x;
    }
    jacobian.topRows(rows) = chain.asDiagonal() * jacobian_;
    for (Eigen::Index i = 0; i < unknowns; ++i)
      jacobian(rows + i, i) = priorWeight(problem_.unknowns()[static_cast<std::size_t>(i)], x[i]);
    return true;
  }

  /// The last Jacobian, if it was taken at `x`; else empty.
  [[nodiscard]] Eigen::MatrixXd knownJacobian(const Eigen::VectorXd& x) const {
    return isKnownAt(x) ? jacobian_ : Eigen::MatrixXd{};
  }

 private:
  [[nodiscard]] bool isKnownAt(const Eigen::VectorXd& x) const {
    return jacobian_at_.size() == x.size() && jacobian_at_ == x;
  }

  /// A point is evaluated up to three times in a row: during a step, as its end, and for its Jacobian.
  const Eigen::VectorXd& residualsAt(const Eigen::VectorXd& x) const {
    if (known_at_.size() == x.size() && known_at_ == x) return known_;
    known_.resize(problem_.evidence().size());
    problem_.residuals(x, known_);
    known_at_ = x;
    return known_;
  }

  const Problem& problem_;
  const Eigen::MatrixXd steps_;
  const double width_;
  // One search, one thread.
  mutable Eigen::VectorXd known_at_, known_, jacobian_at_;
  mutable Eigen::MatrixXd jacobian_;
};

}  // namespace

double priorWeight(const Unknown& unknown, double x) {
  if (!std::isfinite(unknown.sigma)) return 0;
  return (unknown.logarithmic ? unknown.fromSearch(x) : 1) / unknown.sigma;
}

Searched searched(const Problem& problem, Searched from, const Eigen::MatrixXd& steps, int iterations, double width) {
  RobustCost cost{problem, from, steps, width};
  Eigen::VectorXd& x = from.x;
  ceres::Problem::Options plain;
  plain.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem robust{plain};
  robust.AddResidualBlock(&cost, nullptr, x.data());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Unknown& unknown = problem.unknowns()[static_cast<std::size_t>(i)];
    const double low = unknown.toSearch(unknown.low), high = unknown.toSearch(unknown.high);
    x[i] = std::clamp(x[i], low, high);
    robust.SetParameterLowerBound(x.data(), static_cast<int>(i), low);
    robust.SetParameterUpperBound(x.data(), static_cast<int>(i), high);
  }
  ceres::Solver::Options options;
  options.max_num_iterations = iterations;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.function_tolerance = thresholds::kSolverTolerance;
  options.line_search_interpolation_type = ceres::QUADRATIC;  // a cubic one takes slopes at every try
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &robust, &summary);
  return {x, cost.knownJacobian(x)};
}

}  // namespace darwinop::gap
