#include "gap/fit/problem.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "gap/case/plausible.hpp"
#include "gap/parallel/parallel.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
Eigen::Index Evidence::size() const {
  Eigen::Index all = 0;
  for (const LogNoise& log : noise) all += log.size();
  return all;
}

std::vector<Eigen::Index> Evidence::firstRows() const {
  std::vector<Eigen::Index> first_row(logs.size(), 0);
  for (std::size_t i = 1; i < first_row.size(); ++i) first_row[i] = first_row[i - 1] + noise[i - 1].size();
  return first_row;
}

double Evidence::logDeterminant() const {
  double all = 0;
  for (const LogNoise& log : noise) all += log.logDeterminant();
  return all;
}

Evidence evidenceOf(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role,
                    const NoiseOptions& options) {
  Evidence evidence{.plant = &plant, .given = &data, .logs = {}, .noise = {}, .discrepancy = options.discrepancy};
  const auto copies = duplicates(data);
  for (std::size_t i = 0; i < data.logs.size(); ++i)
    if (data.logs[i].held_out == (role == LogRole::kHeldOut) && !copies[i]) evidence.logs.push_back(i);
  evidence.noise = noiseOf(plant, data, evidence.logs, hypothesis, options);
  return evidence;
}

// Pseudo-Huber: smooth, as a search by derivatives needs.
double costOf(double residual) {
  const double share = residual / thresholds::kRobustSigmas;
  return 2 * thresholds::kRobustSigmas * thresholds::kRobustSigmas * (std::sqrt(1 + share * share) - 1);
}

double weightOf(double residual) {
  return 1 / std::sqrt(1 + residual * residual / (thresholds::kRobustSigmas * thresholds::kRobustSigmas));
}

void Problem::residuals(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> out) const {
  const Hypothesis hypothesis = at(x);
  const std::vector<Eigen::Index> first_row = evidence_->firstRows();
  forEach(evidence_->logs.size(),
          [&](std::size_t i) { residualsOfLog(i, hypothesis, out.segment(first_row[i], evidence_->noise[i].size())); });
}

void Problem::residualsOfLog(std::size_t i, const Hypothesis& hypothesis, Eigen::Ref<Eigen::VectorXd> out) const {
  thread_local Trace trace;
  try {
    evidence_->plant->rollOut(*evidence_->given, evidence_->logs[i], hypothesis, {}, trace);
    evidence_->noise[i].residuals(evidence_->given->logs[evidence_->logs[i]], trace, out);
  } catch (const std::runtime_error&) {
    out.setConstant(thresholds::kImpossibleSigmas);
  }
}

double Problem::cost(const Eigen::VectorXd& x) const {
  std::vector<std::size_t> order(evidence_->logs.size());
  std::iota(order.begin(), order.end(), 0U);
  return costUpTo(std::numeric_limits<double>::infinity(), x, order);
}

std::vector<std::size_t> Problem::costliestFirst(const Eigen::VectorXd& residuals) const {
  const std::vector<Eigen::Index> first_row = evidence_->firstRows();
  std::vector<double> costs(first_row.size());
  std::vector<std::size_t> order(first_row.size());
  for (std::size_t i = 0; i < costs.size(); ++i) {
    order[i] = i;
    costs[i] = residuals.segment(first_row[i], evidence_->noise[i].size()).unaryExpr(&costOf).sum();
  }
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return costs[i]; });
  return order;
}

double Problem::costUpTo(double most, const Eigen::VectorXd& x, const std::vector<std::size_t>& order) const {
  const Hypothesis hypothesis = at(x);
  double cost = priorCost(x);
  Eigen::VectorXd of_log;
  for (const std::size_t i : order) {
    if (cost > most) break;
    of_log.resize(evidence_->noise[i].size());
    residualsOfLog(i, hypothesis, of_log);
    cost += of_log.unaryExpr(&costOf).sum();
  }
  return cost <= most ? cost : std::numeric_limits<double>::infinity();
}

double Problem::priorCost(const Eigen::VectorXd& x) const {
  double cost = 0;
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    const Unknown& unknown = unknowns_[i];
    if (!std::isfinite(unknown.sigma)) continue;
    const double off = (unknown.fromSearch(x[static_cast<Eigen::Index>(i)]) - unknown.expected) / unknown.sigma;
    cost += off * off;
  }
  return cost;
}

Eigen::VectorXd Problem::inBounds(Eigen::VectorXd x) const {
  for (std::size_t i = 0; i < unknowns_.size(); ++i) {
    double& value = x[static_cast<Eigen::Index>(i)];
    value = std::clamp(value, unknowns_[i].toSearch(unknowns_[i].low), unknowns_[i].toSearch(unknowns_[i].high));
  }
  return x;
}

Eigen::VectorXd Problem::expected() const {
  Eigen::VectorXd x(static_cast<Eigen::Index>(unknowns_.size()));
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    x[static_cast<Eigen::Index>(i)] = unknowns_[i].toSearch(unknowns_[i].expected);
  return x;
}

}  // namespace darwinop::gap
