#include "gap/fit/solve.hpp"

#include <ceres/ceres.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/sim/parallel.hpp"

namespace darwinop::gap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kWide = 100;        // sigma: below, a residual counts in full while the search is far off
constexpr double kFar = 2.5;         // cost a residual: a right model has about 1
constexpr double kCoarse = 3;        // steps that are so many times too long are worth another search
constexpr double kUnseen = 1e-9;     // of the largest eigenvalue: the data say nothing about this direction
constexpr double kShortest = 1e-6;   // step, in the search variable
constexpr double kLeastGain = 1e-5;  // of the cost: the search is over

/// Slopes of the residuals, a column an unknown, by differences of these steps.
Eigen::MatrixXd slopesAt(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                         const Eigen::VectorXd& steps) {
  Eigen::MatrixXd slopes(residuals.size(), x.size());
  forEach(static_cast<std::size_t>(x.size()), [&](std::size_t index) {
    const auto i = static_cast<Eigen::Index>(index);
    const Unknown& unknown = problem.unknowns()[index];
    double step = steps[i];
    if (x[i] + step > unknown.toSearch(unknown.high)) step = -step;
    Eigen::VectorXd moved = x, there(residuals.size());
    moved[i] += step;
    problem.residuals(moved, there);
    slopes.col(i) = (there - residuals) / step;
  });
  return slopes;
}

/// Slope of the search variable's distance to its prior; 0: it has none.
double priorWeight(const Unknown& unknown, double x) {
  if (!std::isfinite(unknown.sigma)) return 0;
  return (unknown.logarithmic ? unknown.fromSearch(x) : 1) / unknown.sigma;
}

/// Pseudo-Huber's signed root.
double rootOfCost(double residual, double width) {
  const double share = residual / width;
  return std::copysign(width * std::sqrt(2 * (std::sqrt(1 + share * share) - 1)), residual);
}

/// All residuals, each as the root of its cost, so that a plain sum of squares is robust; then the priors.
class RobustCost final : public ceres::CostFunction {
 public:
  RobustCost(const Problem& problem, Eigen::VectorXd steps, double width)
      : problem_{problem}, steps_{std::move(steps)}, width_{width} {
    const int unknowns = static_cast<int>(problem.unknowns().size());
    set_num_residuals(static_cast<int>(problem.evidence().size()) + unknowns);
    mutable_parameter_block_sizes()->push_back(unknowns);
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    const Eigen::Index rows = problem_.evidence().size(), unknowns = steps_.size();
    const Eigen::VectorXd x = Eigen::Map<const Eigen::VectorXd>(parameters[0], unknowns);
    Eigen::VectorXd plain(rows);
    problem_.residuals(x, plain);
    Eigen::Map<Eigen::VectorXd> out{residuals, rows + unknowns};
    out.head(rows) = plain.unaryExpr([this](double r) { return rootOfCost(r, width_); });
    for (Eigen::Index i = 0; i < unknowns; ++i) {
      const Unknown& unknown = problem_.unknowns()[static_cast<std::size_t>(i)];
      const double sigma = unknown.sigma;
      out[rows + i] = std::isfinite(sigma) ? (unknown.fromSearch(x[i]) - unknown.expected) / sigma : 0;
    }
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;

    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Eigen::Map<RowMajor> slopes{jacobians[0], rows + unknowns, unknowns};
    slopes.setZero();
    const Eigen::VectorXd chain = plain.binaryExpr(out.head(rows), [this](double r, double root) {
      return root == 0 ? 1 : r / (root * std::sqrt(1 + r * r / (width_ * width_)));
    });
    slopes.topRows(rows) = chain.asDiagonal() * slopesAt(problem_, x, plain, steps_);
    for (Eigen::Index i = 0; i < unknowns; ++i)
      slopes(rows + i, i) = priorWeight(problem_.unknowns()[static_cast<std::size_t>(i)], x[i]);
    return true;
  }

 private:
  const Problem& problem_;
  const Eigen::VectorXd steps_;
  const double width_;
};

Eigen::VectorXd searched(const Problem& problem, Eigen::VectorXd x, const Eigen::VectorXd& steps, int iterations,
                         double width) {
  RobustCost cost{problem, steps, width};
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
  options.function_tolerance = kLeastGain;
  options.parameter_tolerance = 1e-7;
  options.max_num_consecutive_invalid_steps = 3;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &robust, &summary);
  return x;
}

Eigen::MatrixXd informationOf(const Problem& problem, const Fit& fit) {
  Eigen::VectorXd weight =
      fit.residuals.unaryExpr([](double r) { return 1 / std::sqrt(1 + r * r / (kRobust * kRobust)); });
  Eigen::MatrixXd information = fit.slopes.transpose() * weight.asDiagonal() * fit.slopes;
  for (Eigen::Index i = 0; i < fit.x.size(); ++i) {
    const double prior = priorWeight(problem.unknowns()[static_cast<std::size_t>(i)], fit.x[i]);
    information(i, i) += prior * prior;
  }
  return information;
}

/// Infinite for an unknown that has a part in what the data say nothing about.
Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& information) {
  // In units in which every number that shows anything shows as much.
  const Eigen::VectorXd scale =
      information.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{scale.asDiagonal() * information * scale.asDiagonal()};
  const double least = kUnseen * std::max(1.0, eigen.eigenvalues().maxCoeff());
  const Eigen::Index count = information.cols();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd unseen = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::VectorXd direction = scale.asDiagonal() * eigen.eigenvectors().col(i);
    if (eigen.eigenvalues()[i] > least)
      covariance += direction * direction.transpose() / eigen.eigenvalues()[i];
    else
      unseen += eigen.eigenvectors().col(i).cwiseAbs2();
  }
  for (Eigen::Index i = 0; i < count; ++i)
    if (unseen[i] > 0.01) covariance(i, i) = kInfinity;
  return covariance;
}

/// As long as what the data resolve, where that is shorter.
Eigen::VectorXd finer(Eigen::VectorXd steps, const Eigen::MatrixXd& covariance) {
  for (Eigen::Index i = 0; i < steps.size(); ++i)
    if (std::isfinite(covariance(i, i)))
      steps[i] = std::min(steps[i], std::max(kShortest, std::sqrt(covariance(i, i))));
  return steps;
}

void lookAround(const Problem& problem, Fit& fit) {
  fit.slopes = slopesAt(problem, fit.x, fit.residuals, fit.steps);
  fit.information = informationOf(problem, fit);
  fit.covariance = covarianceOf(fit.information);
}

void look(const Problem& problem, Fit& fit) {
  fit.residuals.resize(problem.evidence().size());
  problem.residuals(fit.x, fit.residuals);
  fit.prior = problem.priorCost(fit.x);
  fit.cost = fit.residuals.unaryExpr(&costOf).sum() + fit.prior;
}

/// From far off by way of plain squares, unless that leads astray.
void search(const Problem& problem, Fit& fit, int iterations) {
  const Fit before = fit;
  if (fit.cost > kFar * static_cast<double>(fit.residuals.size())) {
    fit.x = searched(problem, fit.x, fit.steps, iterations, kWide);
    fit.x = searched(problem, fit.x, fit.steps, iterations, kRobust);
    look(problem, fit);
    if (fit.cost < before.cost) return;
    fit = before;
  }
  fit.x = searched(problem, fit.x, fit.steps, iterations, kRobust);
  look(problem, fit);
  if (fit.cost > before.cost) fit = before;
}

}  // namespace

Fit solve(const Problem& problem, const Eigen::VectorXd& start, const SolveOptions& options) {
  Fit fit;
  fit.x = start;
  fit.steps = options.steps;
  if (fit.steps.size() != start.size()) {
    fit.steps.resize(start.size());
    for (Eigen::Index i = 0; i < start.size(); ++i)
      fit.steps[i] = problem.unknowns()[static_cast<std::size_t>(i)].firstStep();
  }
  look(problem, fit);
  if (start.size() == 0) return fit;
  search(problem, fit, options.iterations);
  if (!options.refine) return fit;

  lookAround(problem, fit);
  const Eigen::VectorXd finest = finer(fit.steps, fit.covariance);
  if ((fit.steps.array() < kCoarse * finest.array()).all()) return fit;
  fit.steps = finest;
  search(problem, fit, options.iterations);
  lookAround(problem, fit);
  return fit;
}

}  // namespace darwinop::gap
