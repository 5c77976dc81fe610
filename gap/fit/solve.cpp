#include "gap/fit/solve.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "gap/fit/jacobian.hpp"
#include "gap/fit/levenberg.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Eigen::MatrixXd informationOf(const Problem& problem, const Fit& fit) {
  const Eigen::VectorXd weight = fit.residuals.unaryExpr(&weightOf);
  Eigen::MatrixXd information = fit.jacobian.transpose() * weight.asDiagonal() * fit.jacobian;
  for (Eigen::Index i = 0; i < fit.x.size(); ++i) {
    const double prior = priorWeight(problem.unknowns()[static_cast<std::size_t>(i)], fit.x[i]);
    information(i, i) += prior * prior;
  }
  return information;
}

/// Infinite for an unknown with a component in a direction that the data do not determine.
Eigen::MatrixXd covarianceOf(const Eigen::MatrixXd& information) {
  // Scaled so that every unknown that the data determine has the same sensitivity.
  const Eigen::VectorXd scale =
      information.diagonal().unaryExpr([](double d) { return d > 0 ? 1 / std::sqrt(d) : 1.0; });
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen{
      Eigen::MatrixXd{scale.asDiagonal() * information * scale.asDiagonal()}};
  const double least = thresholds::kUnobservableEigenvalue * std::max(1.0, eigen.eigenvalues().maxCoeff());
  const Eigen::Index count = information.cols();
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd unobservable = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::VectorXd direction = scale.asDiagonal() * eigen.eigenvectors().col(i);
    if (eigen.eigenvalues()[i] > least)
      covariance += direction * direction.transpose() / eigen.eigenvalues()[i];
    else
      unobservable += eigen.eigenvectors().col(i).cwiseAbs2();
  }
  for (Eigen::Index i = 0; i < count; ++i)
    if (unobservable[i] > thresholds::kUnobservableShare) covariance(i, i) = kInfinity;
  return covariance;
}

/// Jacobian, information and covariance at x; a search knows the Jacobian at its end already.
void lookAround(const Problem& problem, Fit& fit) {
  if (fit.jacobian.size() == 0) fit.jacobian = jacobianAt(problem, fit.x, fit.residuals, fit.steps);
  fit.information = informationOf(problem, fit);
  fit.covariance = covarianceOf(fit.information);
}

/// To a point, with its Jacobian if it is known.
void moveTo(Searched end, Fit& fit) {
  fit.x = std::move(end.x);
  fit.jacobian = std::move(end.jacobian);
}

void look(const Problem& problem, Fit& fit) {
  fit.residuals.resize(problem.evidence().size());
  problem.residuals(fit.x, fit.residuals);
  fit.prior = problem.priorCost(fit.x);
  fit.cost = fit.residuals.unaryExpr(&costOf).sum() + fit.prior;
}

bool isFarOff(const Fit& fit) {
  return fit.cost > thresholds::kFarCost * static_cast<double>(fit.residuals.size());
}

/// From a distant start by way of plain least squares, unless that increases the cost.
void search(const Problem& problem, Fit& fit, int iterations) {
  const Fit before = fit;
  if (isFarOff(fit)) {
    moveTo(searched(problem, {fit.x, fit.jacobian}, fit.steps, iterations, thresholds::kFarRobustSigmas), fit);
    moveTo(searched(problem, {fit.x, fit.jacobian}, fit.steps, (iterations + 1) / 2, thresholds::kRobustSigmas), fit);
    look(problem, fit);
    if (fit.cost < before.cost) return;
    fit = before;
  }
  moveTo(searched(problem, {fit.x, fit.jacobian}, fit.steps, iterations, thresholds::kRobustSigmas), fit);
  look(problem, fit);
  if (fit.cost > before.cost) fit = before;
}

/// Tries points at `multiples` of each step: a delay, backlash, or an arm that comes to rest in one dip of a ripple or
/// in the next make the cost discontinuous, and a gradient search stops there. True: one of them is better.
bool jump(const Problem& problem, const Eigen::MatrixXd& steps, std::span<const double> multiples, Fit& fit) {
  std::vector<Eigen::VectorXd> tries;
  for (Eigen::Index i = 0; i < steps.cols(); ++i)
    for (const double multiple : multiples) tries.push_back(problem.inBounds(fit.x + multiple * steps.col(i)));
  std::vector<double> costs(tries.size());
  const double worth = fit.cost - std::max(thresholds::kJumpGain, thresholds::kJumpGainShare * fit.cost);
  const std::vector<std::size_t> order = problem.costliestFirst(fit.residuals);
  forEach(tries.size(), [&](std::size_t i) { costs[i] = problem.costUpTo(worth, tries[i], order); });
  const auto best = std::ranges::min_element(costs);
  if (best == costs.end() || !std::isfinite(*best)) return false;
  moveTo({tries[static_cast<std::size_t>(best - costs.begin())], {}}, fit);
  look(problem, fit);
  return true;
}

/// The first steps of the unknowns that have no prior; of all where the fit is far off. A released arm that swings once
/// more, or comes to rest elsewhere, is a step in the cost of every number that brakes it.
Eigen::MatrixXd stepsToJump(const Problem& problem, const Fit& fit) {
  const Eigen::MatrixXd all = firstSteps(problem);
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < all.cols(); ++i)
    if (isFarOff(fit) || !std::isfinite(problem.unknowns()[static_cast<std::size_t>(i)].sigma)) chosen.push_back(i);
  return all(Eigen::all, chosen);
}

template <class Steps>
void searchAndJump(const Problem& problem, const Steps& steps_at, std::span<const double> multiples,
                   const SolveOptions& options, Fit& fit) {
  // A search from the wrong side of such a step moves away from the optimum behind it.
  if (isFarOff(fit)) jump(problem, steps_at(fit), multiples, fit);
  search(problem, fit, options.iterations);
  const int most = options.refine ? thresholds::kMaxJumps : 1;
  for (int jumps = 0; jumps < most && jump(problem, steps_at(fit), multiples, fit); ++jumps)
    search(problem, fit, options.iterations);
}

}  // namespace

Fit solve(const Problem& problem, const Eigen::VectorXd& start, const SolveOptions& options) {
  Fit fit;
  fit.x = problem.inBounds(start);  // a linear prediction may be beyond
  fit.steps = options.steps.cols() == start.size() ? options.steps : firstSteps(problem);
  if (fit.x == start) fit.jacobian = options.jacobian;
  look(problem, fit);
  if (start.size() == 0) return fit;
  if (options.iterations > 0)
    searchAndJump(
        problem, [&](const Fit& at) { return stepsToJump(problem, at); }, thresholds::kFirstJumps, options, fit);
  if (!options.refine) {
    fit.jacobian.resize(0, 0);
    return fit;
  }

  lookAround(problem, fit);
  fit.steps = stepsAlong(problem, fit.information);
  fit.jacobian.resize(0, 0);  // by the steps before
  if (options.iterations > 0)
    searchAndJump(
        problem, [steps = fit.steps](const Fit&) { return steps; }, thresholds::kRefinedJumps, options, fit);
  lookAround(problem, fit);
  return fit;
}

}  // namespace darwinop::gap
