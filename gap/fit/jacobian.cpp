#include "gap/fit/jacobian.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// How much of `step` stays inside the bounds.
double roomFor(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& step) {
  double room = 1;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (step[i] == 0) continue;
    const Unknown& unknown = problem.unknowns()[static_cast<std::size_t>(i)];
    const double bound = unknown.toSearch(step[i] > 0 ? unknown.high : unknown.low);
    room = std::min(room, std::max(0.0, (bound - x[i]) / step[i]));
  }
  return room;
}

}  // namespace

Eigen::MatrixXd firstSteps(const Problem& problem) {
  const auto count = static_cast<Eigen::Index>(problem.unknowns().size());
  Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i) steps(i, i) = problem.unknowns()[static_cast<std::size_t>(i)].firstStep();
  return steps;
}

Eigen::MatrixXd stepsAlong(const Problem& problem, const Eigen::MatrixXd& information) {
  const Eigen::VectorXd unit = firstSteps(problem).diagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{
      Eigen::MatrixXd{unit.asDiagonal() * information * unit.asDiagonal()}};
  Eigen::MatrixXd steps = eigen.eigenvectors();
  for (Eigen::Index i = 0; i < steps.cols(); ++i) {
    const double longest = thresholds::kLongestStep / steps.col(i).cwiseAbs().maxCoeff();
    const double seen = eigen.eigenvalues()[i] > 0 ? 1 / std::sqrt(eigen.eigenvalues()[i]) : longest;
    steps.col(i) *= std::clamp(seen, thresholds::kShortestStep, longest);
  }
  return unit.asDiagonal() * steps;
}

Eigen::MatrixXd jacobianAt(const Problem& problem, const Eigen::VectorXd& x, const Eigen::VectorXd& residuals,
                           const Eigen::MatrixXd& steps) {
  Eigen::MatrixXd changes(residuals.size(), steps.cols());
  forEach(static_cast<std::size_t>(steps.cols()), [&](std::size_t index) {
    const auto i = static_cast<Eigen::Index>(index);
    const double ahead = roomFor(problem, x, steps.col(i)), back = roomFor(problem, x, -steps.col(i));
    const double share = ahead >= std::min(1.0, back) ? std::max(thresholds::kLeastStepRoom, ahead)
                                                      : -std::max(thresholds::kLeastStepRoom, back);
    Eigen::VectorXd there(residuals.size());
    problem.residuals(x + share * steps.col(i), there);
    changes.col(i) = (there - residuals) / share;
  });
  return changes * steps.inverse();
}

}  // namespace darwinop::gap
