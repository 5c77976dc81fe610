#include "gap/identify/fitted_model.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "gap/fit/jacobian.hpp"
#include "gap/identify/stuck_log.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

NoiseOptions manyRuns(const Discrepancy& discrepancy) {
  NoiseOptions options;
  options.discrepancy = discrepancy;
  options.runs = discrepancy.any() ? thresholds::kDiscrepancyNoiseRuns : thresholds::kNoiseRuns;
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

double modelEvidence(const FittedModel& fitted) {
  double evidence = -fitted.total;
  Eigen::MatrixXd information = fitted.fit.information;
  for (Eigen::Index i = 0; i < information.cols(); ++i) {
    const Unknown& unknown = fitted.problem.unknowns()[static_cast<std::size_t>(i)];
    const double value = unknown.logarithmic ? unknown.fromSearch(fitted.fit.x[i]) : 1;
    const double width = unknown.toSearch(unknown.high) - unknown.toSearch(unknown.low);
    // A range has the information of a normal distribution of the same standard deviation.
    const double before = std::isfinite(unknown.sigma) ? square(value / unknown.sigma) : 12 / square(width);
    if (!std::isfinite(unknown.sigma)) information(i, i) += before;
    evidence += std::log(before);
  }
  if (information.cols() > 0) evidence -= std::log(std::max(1e-300, information.determinant()));
  return evidence;
}

FittedModel refit(const Study& study, const Effects& effects, Nuisance nuisance, const Problem& from, const Fit& known,
                  int rounds) {
  Hypothesis at = from.at(known.x);
  std::optional<FittedModel> best;
  for (int round = 0; round < rounds; ++round) {
    auto evidence = std::make_shared<const Evidence>(
        evidenceOf(study.plant, study.data, at, LogRole::kFit, manyRuns(from.evidence().discrepancy)));
    Problem problem = problemWith(study, *evidence, effects, nuisance);
    const Problem& last = best ? best->problem : from;
    const Fit& last_fit = best ? best->fit : known;
    const Eigen::VectorXd start = startFrom(problem, last, last_fit.x);
    Fit fit = solve(problem, start, {.steps = stepsFrom(problem, last, last_fit.steps)});
    if (nuisance == Nuisance::kFree && round == 0 &&
        fit.prior > thresholds::kPulledPriorCost) {  // by a model that was far off
      const Fit afresh = solve(problem, startAfresh(problem, last, last_fit.x));
      if (afresh.cost < fit.cost) fit = afresh;
    }
    const double total = fit.cost + evidence->logDeterminant();
    const Eigen::VectorXd moved = fit.x - start;
    const bool stays = moved.dot(fit.information * moved) < thresholds::kRefitMovement;
    at = problem.at(fit.x);
    const bool enough = stays || (best && total > best->total - thresholds::kRefitGain);
    if (!best || total < best->total)
      best = FittedModel{&study, effects, nuisance, std::move(evidence), std::move(problem), std::move(fit), total};
    if (enough) break;
  }
  return std::move(*best);
}

FittedModel baselineAlone(const Study& study, Nuisance nuisance) {
  const Problem problem = problemWith(study, study.evidence, {}, nuisance);
  Fit start;
  start.x = problem.expected();
  FittedModel alone = refit(study, {}, nuisance, problem, start, 4);
  std::optional<FittedModel> past = fittedPastAStuckLog(alone);
  return past ? std::move(*past) : std::move(alone);
}

FittedModel withFreeNuisance(const FittedModel& fitted) {
  Problem problem = problemWith(*fitted.study, *fitted.evidence, fitted.effects, Nuisance::kFree);
  const Eigen::VectorXd x = startFrom(problem, fitted.problem, fitted.fit.x);
  Fit fit = solve(problem, x, {.iterations = 0, .steps = stepsFrom(problem, fitted.problem, fitted.fit.steps)});
  const double total = fit.cost + fitted.evidence->logDeterminant();
  return {fitted.study, fitted.effects, Nuisance::kFree, fitted.evidence, std::move(problem), std::move(fit), total};
}

FittedModel evaluateUnderOwnNoise(const FittedModel& fitted) {
  auto evidence = std::make_shared<const Evidence>(
      evidenceOf(fitted.study->plant, fitted.study->data, fitted.hypothesis(), LogRole::kFit, manyRuns({})));
  Problem problem{*evidence, fitted.problem.hypothesis(), fitted.problem.unknowns()};
  Fit fit = solve(problem, fitted.fit.x, {.iterations = 0, .refine = false});
  const double total = fit.cost + evidence->logDeterminant();
  return {fitted.study,   fitted.effects, fitted.nuisance, std::move(evidence), std::move(problem),
          std::move(fit), total};
}

FittedModel refitUnderNoiseOf(const FittedModel& other, const FittedModel& reference, bool jacobian) {
  return refitUnderNoiseOf(other.effects, other.nuisance, other.problem, other.fit, reference, jacobian);
}

FittedModel refitUnderNoiseOf(const Effects& effects, Nuisance nuisance, const Problem& from, const Fit& known,
                              const FittedModel& reference, bool jacobian) {
  Problem problem = problemWith(*reference.study, *reference.evidence, effects, nuisance);
  Fit fit = solve(
      problem, startFrom(problem, from, known.x),
      {.iterations = thresholds::kRefitIterations, .refine = jacobian, .steps = stepsFrom(problem, from, known.steps)});
  const double total = fit.cost + reference.evidence->logDeterminant();
  return {reference.study, effects, nuisance, reference.evidence, std::move(problem), std::move(fit), total};
}

FittedModel refit(const FittedModel& from, const Effects& effects, int rounds) {
  return refit(*from.study, effects, from.nuisance, from.problem, from.fit, rounds);
}

FittedModel refitWithout(const FittedModel& fitted, std::size_t i, bool jacobian) {
  return refitUnderNoiseOf(without(fitted.effects, i), fitted.nuisance, fitted.problem, fitted.fit, fitted, jacobian);
}

Eigen::VectorXd takenOut(const FittedModel& fitted, const ChosenEffect& effect, Eigen::VectorXd x) {
  const auto& unknowns = fitted.problem.unknowns();
  const twin::EffectSetting* const before = fitted.study->baseline.find(effect.info->id, effect.place);
  for (std::size_t i = 0; i < unknowns.size(); ++i) {
    const EffectParameter* const parameter = unknowns[i].parameterOf(*effect.info);
    if (parameter == nullptr || !(parameter->place == effect.place)) continue;
    const double value = before ? before->values[parameter->index] : parameter->row().neutral;
    x[static_cast<Eigen::Index>(i)] = unknowns[i].toSearch(value);
  }
  return fitted.problem.inBounds(std::move(x));
}

void takeOut(const twin::EffectInfo& effect, const Hypothesis& baseline, Hypothesis& model) {
  std::erase_if(model.effects, [&](const PlacedEffect& one) { return one.info == &effect; });
  for (const PlacedEffect& one : baseline.effects)
    if (one.info == &effect) model.with(effect, one.place).values = one.values;
}

Hypothesis modelWithout(const FittedModel& fitted, std::size_t i) {
  const twin::EffectInfo& effect = *fitted.effects[i].info;
  const Study& study = *fitted.study;
  Hypothesis model = fitted.hypothesis();
  if (!aliasesAPrior(study.data, effect) ||
      priorSigmasMoved(study.data, study.baseline, model, effect) < thresholds::kPriorConflictSigmas)
    return refitWithout(fitted, i).hypothesis();
  takeOut(effect, study.baseline, model);
  return model;
}

}  // namespace darwinop::gap
