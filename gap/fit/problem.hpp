// A hypothesis with unknowns, and its whitened residuals on logs.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/fit/noise.hpp"
#include "gap/fit/unknown.hpp"
#include "gap/plant/position_error.hpp"

namespace darwinop::gap {

/// The logs of a fit, with their noise.
struct Evidence {
  const Plant* plant = nullptr;
  const Case* given = nullptr;
  std::vector<std::size_t> logs;
  std::vector<LogNoise> noise;
  Discrepancy discrepancy = {};

  [[nodiscard]] Eigen::Index size() const;
  /// First residual of each log.
  [[nodiscard]] std::vector<Eigen::Index> firstRows() const;
  [[nodiscard]] double logDeterminant() const;
};
/// The logs of this role, copies of a log once, with the noise that `hypothesis` predicts. `plant` and `data` must
/// outlive it.
Evidence evidenceOf(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role = LogRole::kFit,
                    const NoiseOptions& options = {});

/// Twice the negative log likelihood of one residual, in standard deviations; large ones count linearly.
double costOf(double residual);
/// Weight of the square of such a residual in a quadratic approximation of its cost.
double weightOf(double residual);

class Problem {
 public:
  Problem(const Evidence& evidence, Hypothesis hypothesis, std::vector<Unknown> unknowns)
      : evidence_{&evidence}, hypothesis_{std::move(hypothesis)}, unknowns_{std::move(unknowns)} {}

  /// Of all logs, concatenated.
  void residuals(const Eigen::VectorXd& x, Eigen::Ref<Eigen::VectorXd> out) const;
  /// Sum of costOf() over all residuals and of the prior.
  [[nodiscard]] double cost(const Eigen::VectorXd& x) const;
  /// The same, but infinity as soon as it exceeds `most`. `order`: in which the logs of the evidence are simulated.
  [[nodiscard]] double costUpTo(double most, const Eigen::VectorXd& x, const std::vector<std::size_t>& order) const;
  /// Logs of the evidence, those with the most cost first: what is worse than these residuals shows there the soonest.
  [[nodiscard]] std::vector<std::size_t> costliestFirst(const Eigen::VectorXd& residuals) const;
  [[nodiscard]] double priorCost(const Eigen::VectorXd& x) const;
  [[nodiscard]] Hypothesis at(const Eigen::VectorXd& x) const { return applied(hypothesis_, unknowns_, x.data()); }
  [[nodiscard]] Eigen::VectorXd inBounds(Eigen::VectorXd x) const;
  /// Every unknown at its expected value.
  [[nodiscard]] Eigen::VectorXd expected() const;

  [[nodiscard]] const Evidence& evidence() const { return *evidence_; }
  [[nodiscard]] const Hypothesis& hypothesis() const { return hypothesis_; }
  [[nodiscard]] const std::vector<Unknown>& unknowns() const { return unknowns_; }

 private:
  void residualsOfLog(std::size_t i, const Hypothesis& hypothesis, Eigen::Ref<Eigen::VectorXd> out) const;

  const Evidence* evidence_;
  Hypothesis hypothesis_;
  std::vector<Unknown> unknowns_;
};

}  // namespace darwinop::gap
