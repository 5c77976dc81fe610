#include "gap/name/settled.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "gap/fit/slopes.hpp"

namespace darwinop::gap {
namespace {

constexpr double kNoBetter = 0.5;  // of the total: not worth another round
constexpr double kStays = 30;      // squared sigmas: a fit that moved less has the noise that belongs to it
constexpr double kPulled = 15;     // cost of the priors: the numbers may have been pulled away

NoiseOptions manyRuns(const Unexplained& unexplained) {
  NoiseOptions options;
  options.unexplained = unexplained;
  // As many modes; what lies between the modes of fewer runs looks like an effect.
  options.runs = unexplained.any() ? 24 : 96;
  return options;
}

double square(double value) {
  return value * value;
}

/// The steps of another fit, and first steps for what it does not have; none of its, if it has what `problem` lacks.
Eigen::MatrixXd stepsFrom(const Problem& problem, const Problem& known, const Eigen::MatrixXd& known_steps) {
  Eigen::MatrixXd steps = firstSteps(problem);
  std::vector<Eigen::Index> places;
  for (const Unknown& unknown : known.unknowns()) {
    const auto& mine = problem.unknowns();
    const auto there = std::ranges::find(mine, unknown.name, &Unknown::name);
    if (there == mine.end()) return steps;
    places.push_back(there - mine.begin());
  }
  if (known_steps.cols() != static_cast<Eigen::Index>(places.size())) return steps;
  for (std::size_t row = 0; row < places.size(); ++row)
    for (std::size_t column = 0; column < places.size(); ++column)
      steps(places[row], places[column]) =
          known_steps(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
  return steps;
}

}  // namespace

double evidenceFor(const Settled& fitted) {
  double evidence = -fitted.total;
  Eigen::MatrixXd information = fitted.fit.information;
  for (Eigen::Index i = 0; i < information.cols(); ++i) {
    const Unknown& unknown = fitted.problem.unknowns()[static_cast<std::size_t>(i)];
    const double value = unknown.logarithmic ? unknown.fromSearch(fitted.fit.x[i]) : 1;
    const double width = unknown.toSearch(unknown.high) - unknown.toSearch(unknown.low);
    // A range says as much as a bell of its standard deviation.
    const double before = std::isfinite(unknown.sigma) ? square(value / unknown.sigma) : 12 / square(width);
    if (!std::isfinite(unknown.sigma)) information(i, i) += before;
    evidence += std::log(before);
  }
  if (information.cols() > 0) evidence -= std::log(std::max(1e-300, information.determinant()));
  return evidence;
}

Settled settle(const Effects& effects, Numbers numbers, const Problem& from, const Fit& known, int rounds) {
  const Case& given = *from.evidence().given;
  Hypothesis at = from.at(known.x);
  std::optional<Settled> best;
  for (int round = 0; round < rounds; ++round) {
    auto evidence =
        std::make_shared<const Evidence>(evidenceOf(given, at, false, manyRuns(from.evidence().unexplained)));
    Problem problem = problemWith(*evidence, effects, numbers);
    const Problem& last = best ? best->problem : from;
    const Fit& last_fit = best ? best->fit : known;
    const Eigen::VectorXd start = startFrom(problem, last, last_fit.x);
    Fit fit = solve(problem, start, {.steps = stepsFrom(problem, last, last_fit.steps)});
    if (numbers == Numbers::kFree && round == 0 && fit.prior > kPulled) {  // by a model that was far off
      const Fit afresh = solve(problem, startAfresh(problem, last, last_fit.x));
      if (afresh.cost < fit.cost) fit = afresh;
    }
    const double total = fit.cost + evidence->logDeterminant();
    const Eigen::VectorXd moved = fit.x - start;
    const bool stays = moved.dot(fit.information * moved) < kStays;
    at = problem.at(fit.x);
    const bool enough = stays || (best && total > best->total - kNoBetter);
    if (!best || total < best->total)
      best = Settled{effects, numbers, std::move(evidence), std::move(problem), std::move(fit), total};
    if (enough) break;
  }
  return std::move(*best);
}

Settled withFreeNumbers(const Settled& fitted) {
  Problem problem = problemWith(*fitted.evidence, fitted.effects, Numbers::kFree);
  const Eigen::VectorXd x = startFrom(problem, fitted.problem, fitted.fit.x);
  Fit fit = solve(problem, x, {.iterations = 0, .steps = stepsFrom(problem, fitted.problem, fitted.fit.steps)});
  const double total = fit.cost + fitted.evidence->logDeterminant();
  return {fitted.effects, Numbers::kFree, fitted.evidence, std::move(problem), std::move(fit), total};
}

Settled onNoiseOfItsOwn(const Settled& fitted) {
  auto evidence =
      std::make_shared<const Evidence>(evidenceOf(*fitted.evidence->given, fitted.hypothesis(), false, manyRuns({})));
  Problem problem{*evidence, fitted.problem.hypothesis(), fitted.problem.unknowns()};
  Fit fit = solve(problem, fitted.fit.x, {.iterations = 0, .refine = false});
  const double total = fit.cost + evidence->logDeterminant();
  return {fitted.effects, fitted.numbers, std::move(evidence), std::move(problem), std::move(fit), total};
}

Settled onNoiseOf(const Settled& other, const Settled& judge, bool slopes) {
  return onNoiseOf(other.effects, other.numbers, other.problem, other.fit, judge, slopes);
}

Settled onNoiseOf(const Effects& effects, Numbers numbers, const Problem& from, const Fit& known, const Settled& judge,
                  bool slopes) {
  Problem problem = problemWith(*judge.evidence, effects, numbers);
  Fit fit = solve(problem, startFrom(problem, from, known.x),
                  {.iterations = 8, .refine = slopes, .steps = stepsFrom(problem, from, known.steps)});
  const double total = fit.cost + judge.evidence->logDeterminant();
  return {effects, numbers, judge.evidence, std::move(problem), std::move(fit), total};
}

}  // namespace darwinop::gap
