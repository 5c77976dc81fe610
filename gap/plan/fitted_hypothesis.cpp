#include "gap/plan/fitted_hypothesis.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "core/conversions.hpp"
#include "core/text/nearest.hpp"
#include "gap/case/data_check.hpp"
#include "gap/fit/servo_range.hpp"
#include "gap/fit/solve.hpp"
#include "gap/identify/effect_set.hpp"
#include "gap/identify/ripple_starts.hpp"
#include "gap/identify/start_grid.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/plan/messages.hpp"
#include "gap/plan/thresholds.hpp"
#include "gap/thresholds.hpp"
#include "twin/effects/catalogue.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::gap {
namespace {

/// A copied log adds no information.
Case withoutCopies(const Case& given) {
  const DataCheck check = checkData(given);
  Case distinct = given;
  distinct.logs.clear();
  for (std::size_t i = 0; i < given.logs.size(); ++i) {
    if (check.logs[i].duplicate_of) continue;
    distinct.logs.push_back(given.logs[i]);
    distinct.logs.back().repeat_of.reset();  // its index may have changed, and fits do not use it
  }
  return distinct;
}

const twin::EffectInfo& effectCalled(const Case& given, const std::string& id) {
  const twin::EffectInfo* const effect = twin::findEffect(id);
  if (effect == nullptr) {
    const std::vector<std::string_view> known = twin::effectIds();
    throw std::runtime_error("there is no effect '" + id + "'; " + text::suggestion(id, known));
  }
  const std::vector<const twin::EffectInfo*> candidates = candidateEffectsOf(given);
  if (std::ranges::find(candidates, effect) == candidates.end())
    throw std::runtime_error("'" + id + "' " + messages::kEffectNotFittable +
                             ": with this baseline and a log of positions it does not show");
  return *effect;
}

/// Values of an effect's unknowns to begin a fit at.
std::vector<std::vector<double>> startsOf(const twin::EffectInfo& effect, const twin::ServoParameters& servo) {
  if (!isRipple(effect)) return gridOf(unknownsOf(effect, servo));
  std::vector<std::vector<double>> ripples;  // amplitude, count a turn, phase
  for (int count = 1; count <= thresholds::kMaxRipplesPerTurn; ++count)
    for (const double phase : {0.0, kPi / 2}) ripples.push_back({0.01, static_cast<double>(count), phase});
  return ripples;
}

/// The start of `problem`, whose last unknowns are the effect's, that costs least.
Eigen::VectorXd bestStart(const Problem& problem, const Eigen::VectorXd& from, const twin::EffectInfo& effect) {
  std::vector<Eigen::VectorXd> starts{from};
  const auto own = static_cast<Eigen::Index>(unknownsOf(effect).size());
  const twin::ServoParameters& servo = problem.hypothesis().servo;
  for (const std::vector<double>& values : own == 0 ? std::vector<std::vector<double>>{} : startsOf(effect, servo)) {
    Eigen::VectorXd x = from;
    for (Eigen::Index k = 0; k < own; ++k) {
      const Eigen::Index at = x.size() - own + k;
      x[at] = problem.unknowns()[static_cast<std::size_t>(at)].toSearch(values[static_cast<std::size_t>(k)]);
    }
    starts.push_back(std::move(x));
  }
  std::vector<double> costs(starts.size());
  forEach(starts.size(), [&](std::size_t i) { costs[i] = problem.cost(starts[i]); });
  return starts[static_cast<std::size_t>(std::ranges::min_element(costs) - costs.begin())];
}

FittedHypothesis fitted(const Study& study, const std::vector<const twin::EffectInfo*>& set) {
  const Evidence& evidence = study.evidence;
  Effects effects;
  Problem problem = problemWith(study, evidence, effects, Nuisance::kFree);
  Eigen::VectorXd x = problem.expected();
  for (const twin::EffectInfo* const effect : set) {  // one after the other, as identification adds them
    effects.push_back({effect});
    Problem with = problemWith(study, evidence, effects, Nuisance::kFree);
    x = bestStart(with, startFrom(with, problem, x), *effect);
    problem = std::move(with);
    x = solve(problem, x, {.iterations = thresholds::kPlannedFitIterations, .refine = false}).x;
  }
  // Fitted again under the noise of the fitted model. For a roughly known servo the discrepancy counts as noise.
  NoiseOptions options;
  options.runs = thresholds::kNoiseRuns;
  if (isRoughlyKnown(study.data))
    options.discrepancy = discrepancyOf(study.plant, study.data, evidence.logs, problem.at(x));
  const Evidence own = evidenceOf(study.plant, study.data, problem.at(x), LogRole::kFit, options);
  const Problem final_problem = problemWith(study, own, effects, Nuisance::kFree);
  const Fit fit = solve(final_problem, x);
  FittedHypothesis result{.name = "",
                          .hypothesis = final_problem.hypothesis(),
                          .unknowns = final_problem.unknowns(),
                          .x = fit.x,
                          .information = {},
                          .cost = fit.cost,
                          .discrepancy = options.discrepancy};
  for (const twin::EffectInfo* const effect : set)
    result.name += (result.name.empty() ? "" : " + ") + std::string{effect->id};
  if (set.empty()) result.name = kNothing;
  result.information = informationOf(result.unknowns, result.x, fit.jacobian);
  return result;
}

}  // namespace

Eigen::VectorXd FittedHypothesis::sigmas() const {
  if (x.size() == 0) return {};
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(x.size(), x.size());
  return information.ldlt().solve(unit).diagonal().cwiseMax(0).cwiseSqrt();
}

Eigen::MatrixXd informationOf(const std::vector<Unknown>& unknowns, const Eigen::VectorXd& x,
                              const Eigen::MatrixXd& jacobian) {
  constexpr double kFlat = 12;  // variance of a flat prior: its width squared over this
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(x.size(), x.size());
  if (jacobian.rows() > 0) information = jacobian.transpose() * jacobian;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    const double width = unknown.toSearch(unknown.high) - unknown.toSearch(unknown.low);
    information(i, i) += kFlat / (width * width);
    if (!std::isfinite(unknown.sigma)) continue;
    const double chain = unknown.logarithmic ? unknown.fromSearch(x[i]) : 1;
    information(i, i) += chain * chain / (unknown.sigma * unknown.sigma);
  }
  return information;
}

std::vector<FittedHypothesis> fitHypotheses(const Case& given, const std::vector<std::vector<std::string>>& sets,
                                            const std::function<void(const std::string&)>& progress) {
  std::vector<std::vector<const twin::EffectInfo*>> effects;
  for (const std::vector<std::string>& ids : sets) {
    effects.emplace_back();
    for (const std::string& id : ids) effects.back().push_back(&effectCalled(given, id));
  }
  const Case distinct = withoutCopies(given);
  const Study study{distinct};
  std::vector<FittedHypothesis> hypotheses;
  for (const auto& set : effects) {
    hypotheses.push_back(fitted(study, set));
    progress("fitted " + hypotheses.back().name);
  }
  return hypotheses;
}

}  // namespace darwinop::gap
