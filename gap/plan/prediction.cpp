#include "gap/plan/prediction.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/fit/problem.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plan/thresholds.hpp"
#include "gap/plants.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

double stepOf(const Unknown& unknown, double x, double sigma) {
  const double low = unknown.toSearch(unknown.low), high = unknown.toSearch(unknown.high);
  const double step = std::clamp(sigma, thresholds::kShortestPredictionStep * unknown.firstStep(),
                                 thresholds::kLongestPredictionStep * (high - low));
  return x + step > high ? -step : step;
}

std::vector<Trace> tracesOf(const Case& coming, const Hypothesis& hypothesis) {
  std::vector<Trace> traces(coming.logs.size());
  for (std::size_t i = 0; i < traces.size(); ++i) plantOf(coming).rollOut(coming, i, hypothesis, {}, traces[i]);
  return traces;
}

/// What a model leaves on some logs, expected of as many others as there are.
Discrepancy elsewhere(Discrepancy left, std::size_t logs) {
  double squares = 0, fitted = 0;
  for (const double load : left.load)
    if (load > 0) squares += load * load, ++fitted;
  left.load.assign(logs, fitted > 0 ? std::sqrt(squares / fitted) : 0);
  return left;
}

/// Of all logs in units of `noise`: `actual` minus `predicted`.
Eigen::VectorXd residualsOf(const Case& coming, const std::vector<LogNoise>& noise, const std::vector<Trace>& actual,
                            const std::vector<Trace>& predicted) {
  Eigen::Index rows = 0, row = 0;
  for (const LogNoise& log : noise) rows += log.size();
  Eigen::VectorXd all(rows);
  Trajectory measured;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    measured.p_register = coming.logs[i].p_register;
    measured.position_rad = actual[i][kPositionSignal];
    measured.load = actual[i][kLoadSignal];
    noise[i].residuals(measured, predicted[i], all.segment(row, noise[i].size()));
    row += noise[i].size();
  }
  return all;
}

/// Least of the robust cost of off + jacobian * x, plus x' information x.
double leastCost(const Eigen::VectorXd& off, const Eigen::MatrixXd& jacobian, const Eigen::MatrixXd& information) {
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(off.size());
  Eigen::VectorXd left = off;
  double least = off.unaryExpr(&costOf).sum();
  for (int round = 0; round < thresholds::kPredictionReweightings && jacobian.cols() > 0; ++round) {
    const Eigen::MatrixXd weighted = weights.asDiagonal() * jacobian;
    const Eigen::MatrixXd normal = jacobian.transpose() * weighted + information;
    const Eigen::VectorXd x = -normal.ldlt().solve(weighted.transpose() * off);
    left = off + jacobian * x;
    least = std::min(least, left.unaryExpr(&costOf).sum() + x.dot(information * x));
    weights = left.unaryExpr(
        [](double r) { return 1 / std::sqrt(1 + r * r / (thresholds::kRobustSigmas * thresholds::kRobustSigmas)); });
  }
  return least;
}

/// Under the noise of one of the two.
double costBetween(const Case& coming, const std::vector<LogNoise>& noise, const FittedHypothesis& a,
                   const Prediction& of_a, const FittedHypothesis& b, const Prediction& of_b) {
  const Eigen::VectorXd off = residualsOf(coming, noise, of_a.expected, of_b.expected);
  const Eigen::Index of_first = of_a.steps.size(), of_second = of_b.steps.size();
  Eigen::MatrixXd jacobian(off.size(), of_first + of_second);
  for (Eigen::Index i = 0; i < of_first; ++i)
    jacobian.col(i) =
        (residualsOf(coming, noise, of_a.moved[static_cast<std::size_t>(i)], of_b.expected) - off) / of_a.steps[i];
  for (Eigen::Index i = 0; i < of_second; ++i)
    jacobian.col(of_first + i) =
        (residualsOf(coming, noise, of_a.expected, of_b.moved[static_cast<std::size_t>(i)]) - off) / of_b.steps[i];
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(jacobian.cols(), jacobian.cols());
  if (of_first > 0) information.topLeftCorner(of_first, of_first) = a.information;
  if (of_second > 0) information.bottomRightCorner(of_second, of_second) = b.information;
  return leastCost(off, jacobian, information);
}

}  // namespace

Eigen::Index Prediction::size() const {
  Eigen::Index all = 0;
  for (const LogNoise& log : noise) all += log.size();
  return all;
}

Prediction predict(const Case& coming, const FittedHypothesis& hypothesis, int noise_runs) {
  Prediction prediction;
  prediction.expected = tracesOf(coming, hypothesis.best());
  const Eigen::VectorXd sigmas = hypothesis.sigmas();
  prediction.steps.resize(hypothesis.x.size());
  prediction.moved.resize(hypothesis.unknowns.size());
  forEach(hypothesis.unknowns.size(), [&](std::size_t i) {
    const auto at = static_cast<Eigen::Index>(i);
    prediction.steps[at] = stepOf(hypothesis.unknowns[i], hypothesis.x[at], sigmas[at]);
    Eigen::VectorXd x = hypothesis.x;
    x[at] += prediction.steps[at];
    prediction.moved[i] = tracesOf(coming, hypothesis.at(x));
  });
  if (noise_runs == 0) return prediction;
  std::vector<std::size_t> logs(coming.logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) logs[i] = i;
  NoiseOptions options;
  options.runs = noise_runs;
  options.discrepancy = elsewhere(hypothesis.discrepancy, coming.logs.size());
  Case recorded = coming;  // every row of it, and from where it begins
  for (Trajectory& log : recorded.logs) {
    std::ranges::fill(log.position_rad, log.position_rad.front());
    std::ranges::fill(log.load, 0);
  }
  prediction.noise = noiseOf(plantOf(recorded), recorded, logs, hypothesis.best(), options);
  return prediction;
}

double separationOf(const Case& coming, const FittedHypothesis& a, const Prediction& of_a, const FittedHypothesis& b,
                    const Prediction& of_b) {
  double cost = std::numeric_limits<double>::infinity();
  for (const Prediction* const judge : {&of_a, &of_b})
    if (!judge->noise.empty()) cost = std::min(cost, costBetween(coming, judge->noise, a, of_a, b, of_b));
  return std::sqrt(cost);
}

Eigen::MatrixXd informationFrom(const Case& coming, const Prediction& prediction) {
  Eigen::MatrixXd jacobian(prediction.size(), prediction.steps.size());
  for (Eigen::Index i = 0; i < jacobian.cols(); ++i)
    jacobian.col(i) =
        residualsOf(coming, prediction.noise, prediction.expected, prediction.moved[static_cast<std::size_t>(i)]) /
        prediction.steps[i];
  return jacobian.transpose() * jacobian;
}

}  // namespace darwinop::gap
