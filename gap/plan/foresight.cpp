#include "gap/plan/foresight.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "gap/fit/problem.hpp"
#include "gap/sim/parallel.hpp"

namespace darwinop::gap {
namespace {

constexpr double kWidestStep = 0.1;  // of the range: beyond that, a slope is no slope

double stepOf(const Unknown& unknown, double x, double sigma) {
  const double low = unknown.toSearch(unknown.low), high = unknown.toSearch(unknown.high);
  const double step = std::clamp(sigma, 0.2 * unknown.firstStep(), kWidestStep * (high - low));
  return x + step > high ? -step : step;
}

std::vector<Trace> tracesOf(const Case& coming, const Hypothesis& hypothesis) {
  std::vector<Trace> traces(coming.logs.size());
  for (std::size_t i = 0; i < traces.size(); ++i) rollOut(coming, i, hypothesis, {}, traces[i]);
  return traces;
}

/// Of all logs in units of `noise`: `happened` measured, `foretold` simulated.
Eigen::VectorXd residualsOf(const Case& coming, const std::vector<LogNoise>& noise, const std::vector<Trace>& happened,
                            const std::vector<Trace>& foretold) {
  Eigen::Index rows = 0, row = 0;
  for (const LogNoise& log : noise) rows += log.size();
  Eigen::VectorXd all(rows);
  Trajectory measured;
  for (std::size_t i = 0; i < noise.size(); ++i) {
    measured.p_register = coming.logs[i].p_register;
    measured.position_rad = happened[i].position_rad;
    measured.load = happened[i].load;
    noise[i].residuals(measured, foretold[i], all.segment(row, noise[i].size()));
    row += noise[i].size();
  }
  return all;
}

/// Least of the robust cost of off + slopes * x, plus x' information x.
double leastCost(const Eigen::VectorXd& off, const Eigen::MatrixXd& slopes, const Eigen::MatrixXd& information) {
  constexpr int kRounds = 6;  // large residuals count less each time; it settles in three or four
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(off.size());
  Eigen::VectorXd left = off;
  double least = off.unaryExpr(&costOf).sum();
  for (int round = 0; round < kRounds && slopes.cols() > 0; ++round) {
    const Eigen::MatrixXd weighted = weights.asDiagonal() * slopes;
    const Eigen::MatrixXd normal = slopes.transpose() * weighted + information;
    const Eigen::VectorXd x = -normal.ldlt().solve(weighted.transpose() * off);
    left = off + slopes * x;
    least = std::min(least, left.unaryExpr(&costOf).sum() + x.dot(information * x));
    weights = left.unaryExpr([](double r) { return 1 / std::sqrt(1 + r * r / (kRobust * kRobust)); });
  }
  return least;
}

/// Judged by the noise of one of the two.
double costBetween(const Case& coming, const std::vector<LogNoise>& noise, const Contender& a, const Foresight& of_a,
                   const Contender& b, const Foresight& of_b) {
  const Eigen::VectorXd off = residualsOf(coming, noise, of_a.expected, of_b.expected);
  const Eigen::Index of_first = of_a.steps.size(), of_second = of_b.steps.size();
  Eigen::MatrixXd slopes(off.size(), of_first + of_second);
  for (Eigen::Index i = 0; i < of_first; ++i)
    slopes.col(i) =
        (residualsOf(coming, noise, of_a.moved[static_cast<std::size_t>(i)], of_b.expected) - off) / of_a.steps[i];
  for (Eigen::Index i = 0; i < of_second; ++i)
    slopes.col(of_first + i) =
        (residualsOf(coming, noise, of_a.expected, of_b.moved[static_cast<std::size_t>(i)]) - off) / of_b.steps[i];
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(slopes.cols(), slopes.cols());
  if (of_first > 0) information.topLeftCorner(of_first, of_first) = a.information;
  if (of_second > 0) information.bottomRightCorner(of_second, of_second) = b.information;
  return leastCost(off, slopes, information);
}

}  // namespace

Eigen::Index Foresight::size() const {
  Eigen::Index all = 0;
  for (const LogNoise& log : noise) all += log.size();
  return all;
}

Foresight foresee(const Case& coming, const Contender& contender, int noise_runs) {
  Foresight foresight;
  foresight.expected = tracesOf(coming, contender.best());
  const Eigen::VectorXd sigmas = contender.sigmas();
  foresight.steps.resize(contender.x.size());
  foresight.moved.resize(contender.unknowns.size());
  forEach(contender.unknowns.size(), [&](std::size_t i) {
    const auto at = static_cast<Eigen::Index>(i);
    foresight.steps[at] = stepOf(contender.unknowns[i], contender.x[at], sigmas[at]);
    Eigen::VectorXd x = contender.x;
    x[at] += foresight.steps[at];
    foresight.moved[i] = tracesOf(coming, contender.at(x));
  });
  if (noise_runs == 0) return foresight;
  std::vector<std::size_t> logs(coming.logs.size());
  for (std::size_t i = 0; i < logs.size(); ++i) logs[i] = i;
  NoiseOptions options;
  options.runs = noise_runs;
  foresight.noise = noiseOf(coming, logs, contender.best(), options);
  return foresight;
}

double separationOf(const Case& coming, const Contender& a, const Foresight& of_a, const Contender& b,
                    const Foresight& of_b) {
  double cost = std::numeric_limits<double>::infinity();
  for (const Foresight* const judge : {&of_a, &of_b})
    if (!judge->noise.empty()) cost = std::min(cost, costBetween(coming, judge->noise, a, of_a, b, of_b));
  return std::sqrt(cost);
}

Eigen::MatrixXd informationFrom(const Case& coming, const Foresight& foresight) {
  Eigen::MatrixXd slopes(foresight.size(), foresight.steps.size());
  for (Eigen::Index i = 0; i < slopes.cols(); ++i)
    slopes.col(i) =
        residualsOf(coming, foresight.noise, foresight.expected, foresight.moved[static_cast<std::size_t>(i)]) /
        foresight.steps[i];
  return slopes.transpose() * slopes;
}

}  // namespace darwinop::gap
