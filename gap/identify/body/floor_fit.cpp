#include "gap/identify/body/floor_fit.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "gap/identify/body/mechanics_fit.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kMostTraces = 48;  // a megabyte each
constexpr double kLeastFloorGain = 0.5;  // cost
constexpr double kMostFloorDamping = 1e4;

struct FreeNumber {
  std::size_t effect, number;
};

const FloorEffect::Number& numberAt(const FloorSet& set, const FreeNumber& at) {
  return set[at.effect].effect->numbers[at.number];
}

/// Prior residuals of all numbers.
std::vector<double> priorsOf(const FloorSet& set) {
  std::vector<double> out;
  for (const PlacedFloor& placed : set)
    for (std::size_t i = 0; i < placed.values.size(); ++i) {
      const FloorEffect::Number& number = placed.effect->numbers[i];
      if (number.prior_sigma > 0) out.push_back(number.priorOf(placed.values[i]));
    }
  return out;
}

Eigen::VectorXd withPriors(const FloorSet& set, const Eigen::VectorXd& residuals) {
  const std::vector<double> priors = priorsOf(set);
  Eigen::VectorXd out(residuals.size() + std::ssize(priors));
  out << residuals, Eigen::Map<const Eigen::VectorXd>{priors.data(), std::ssize(priors)};
  return out;
}

}  // namespace

FloorModel FloorEvaluator::modelOf(const FloorSet& set) const {
  FloorModel out = base_;
  for (const PlacedFloor& placed : set) placed.effect->apply(out, placed.values);
  return out;
}

FloorEvaluator::Key FloorEvaluator::keyOf(const FloorSet& set) {
  Key key;
  for (const PlacedFloor& placed : set) {
    if (placed.effect->is_of_sensor) continue;
    for (const std::string_view name : {placed.effect->id, placed.effect->at})
      key.push_back(static_cast<double>(std::hash<std::string_view>{}(name) % 1'000'003));
    key.insert(key.end(), placed.values.begin(), placed.values.end());
  }
  return key;
}

void FloorEvaluator::simulateMissing(const std::vector<FloorSet>& sets) {
  std::map<Key, FloorHypothesis> missing;
  for (const FloorSet& set : sets)
    if (const Key key = keyOf(set); !key.empty() && !traces_.contains(key)) missing.emplace(key, modelOf(set).robot);
  if (missing.empty()) return;
  if (traces_.size() > kMostTraces) {
    traces_.clear();
    return simulateMissing(sets);
  }
  std::vector<FloorHypothesis> hypotheses;
  for (const auto& [key, hypothesis] : missing) hypotheses.push_back(hypothesis);
  std::vector<FloorTraces> simulated = residuals_->simulate(hypotheses);
  simulations_ += hypotheses.size();
  std::size_t i = 0;
  for (const auto& [key, hypothesis] : missing) traces_.insert_or_assign(key, std::move(simulated[i++]));
}

const FloorTraces& FloorEvaluator::tracesOf(const FloorSet& set) {
  const Key key = keyOf(set);
  if (key.empty() && !traces_.contains(key)) traces_.emplace(key, of_base_->baseTraces());
  simulateMissing({set});
  return traces_.at(key);
}

std::vector<Eigen::VectorXd> FloorEvaluator::residuals(const std::vector<FloorSet>& sets) {
  simulateMissing(sets);
  std::vector<Eigen::VectorXd> out;
  for (const FloorSet& set : sets) {
    EngineNumber own = EngineNumber::kNone;
    for (const PlacedFloor& placed : set)
      if (placed.effect->of_engine != EngineNumber::kNone) own = placed.effect->of_engine;
    out.push_back(residuals_->of(tracesOf(set), modelOf(set).imu, own));
  }
  return out;
}

std::vector<FloorLogRows> FloorEvaluator::rowsOfLogs() const {
  std::vector<FloorLogRows> out;
  for (const FloorSamples& block : residuals_->blocks()) {
    if (block.signal == 0) out.push_back({.begin = block.begin});  // the first signal of a log
    out.back().rows += block.rows;
  }
  return out;
}

double costOf(const FloorSet& set, const Eigen::VectorXd& residuals) {
  return robustCost(withPriors(set, residuals));
}

FloorFit fitFloor(FloorEvaluator& evaluator, FloorSet set, int iterations) {
  FloorFit fit{.set = std::move(set), .sigmas = {}};
  std::vector<FreeNumber> free;
  for (std::size_t effect = 0; effect < fit.set.size(); ++effect) {
    fit.sigmas.emplace_back(fit.set[effect].values.size(), 0.0);
    for (std::size_t number = 0; number < fit.set[effect].values.size(); ++number)
      if (!numberAt(fit.set, {effect, number}).is_fixed) free.push_back({effect, number});
  }
  fit.numbers = free.size();
  const auto n = std::ssize(free);
  const auto at = [&](const Eigen::VectorXd& x) {
    FloorSet out = fit.set;
    for (std::size_t i = 0; i < free.size(); ++i)
      out[free[i].effect].values[free[i].number] = numberAt(out, free[i]).fromSearch(x[static_cast<Eigen::Index>(i)]);
    return out;
  };
  Eigen::VectorXd x(n);
  for (std::size_t i = 0; i < free.size(); ++i)
    x[static_cast<Eigen::Index>(i)] =
        numberAt(fit.set, free[i]).inSearch(fit.set[free[i].effect].values[free[i].number]);
  Eigen::VectorXd z = withPriors(fit.set, evaluator.residuals({fit.set}).front());
  fit.cost = robustCost(z);
  Eigen::MatrixXd of_data = Eigen::MatrixXd::Zero(n, n), of_priors = Eigen::MatrixXd::Identity(n, n);
  double damping = 1e-2;
  for (int iteration = 0; iteration < iterations && n > 0; ++iteration) {
    std::vector<FloorSet> moved;
    std::vector<double> steps;
    for (Eigen::Index i = 0; i < n; ++i) {
      const FloorEffect::Number& number = numberAt(fit.set, free[static_cast<std::size_t>(i)]);
      double step = number.step;
      if (number.fromSearch(x[i] + step) == number.fromSearch(x[i])) step = -step;
      steps.push_back(step);
      moved.push_back(at(x + step * Eigen::VectorXd::Unit(n, i)));
    }
    const std::vector<Eigen::VectorXd> there = evaluator.residuals(moved);
    Eigen::MatrixXd jacobian(z.size(), n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      jacobian.col(i) = (withPriors(moved[k], there[k]) - z) / steps[k];
    }
    // Derivative of the robust cost: weight of each residual.
    const Eigen::VectorXd weight = (1 + (z.array() / thresholds::kRobustSigmas).square()).rsqrt();
    const auto informationOf = [&](Eigen::Index first, Eigen::Index rows) -> Eigen::MatrixXd {
      const auto part = jacobian.middleRows(first, rows);
      return part.transpose() * weight.segment(first, rows).asDiagonal() * part;
    };
    of_data = informationOf(0, evaluator.size());
    of_priors = informationOf(evaluator.size(), z.size() - evaluator.size());
    const Eigen::VectorXd slope = jacobian.transpose() * weight.cwiseProduct(z);
    const double before = fit.cost;
    for (; damping < kMostFloorDamping; damping *= 10) {
      Eigen::MatrixXd left = of_data + of_priors;
      left.diagonal() *= 1 + damping;
      left.diagonal().array() += 1e-9;
      const FloorSet next = at(x - left.ldlt().solve(slope));
      const Eigen::VectorXd z_next = withPriors(next, evaluator.residuals({next}).front());
      const double cost = robustCost(z_next);
      if (!(cost < fit.cost)) continue;
      fit.set = next, z = z_next, fit.cost = cost;
      for (std::size_t i = 0; i < free.size(); ++i)
        x[static_cast<Eigen::Index>(i)] = numberAt(next, free[i]).inSearch(next[free[i].effect].values[free[i].number]);
      damping = std::max(1e-6, damping / 10);
      break;
    }
    if (before - fit.cost < std::max(kLeastFloorGain, thresholds::kFloorTolerance * before)) break;
  }
  if (n == 0) return fit;
  // Samples of a log depend on each other, and what no model explains is not noise: both widen what data show.
  const double of_noise = thresholds::kFloorCostOfNoise * static_cast<double>(evaluator.size());
  Eigen::MatrixXd information =
      of_data / (thresholds::kCorrelatedSamples * std::max(1.0, fit.cost / of_noise)) + of_priors;
  information.diagonal().array() += 1e-9;
  const Eigen::MatrixXd covariance = information.inverse();
  for (std::size_t i = 0; i < free.size(); ++i) {
    const FloorEffect::Number& number = numberAt(fit.set, free[i]);
    const auto k = static_cast<Eigen::Index>(i);
    const double sigma = std::sqrt(std::max(0.0, covariance(k, k)));
    fit.sigmas[free[i].effect][free[i].number] =
        number.is_logarithmic ? sigma * fit.set[free[i].effect].values[free[i].number] : sigma;
  }
  return fit;
}

}  // namespace darwinop::gap
