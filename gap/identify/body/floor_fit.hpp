// Fits of sets of effects to the recordings on the floor.
#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "gap/identify/body/floor_effect.hpp"

namespace darwinop::gap {

/// The whitened residuals of a log.
struct FloorLogRows {
  Eigen::Index begin = 0, rows = 0;
};

/// Residuals of models with some effects. Simulates each model once: those that differ in sensors only share it.
class FloorEvaluator {
 public:
  FloorEvaluator(const FloorResiduals& residuals, FloorModel base)
      : residuals_{&residuals}, of_base_{&residuals}, base_{std::move(base)} {}

  [[nodiscard]] FloorModel modelOf(const FloorSet& set) const;
  /// Whitened.
  std::vector<Eigen::VectorXd> residuals(const std::vector<FloorSet>& sets);
  const FloorTraces& tracesOf(const FloorSet& set);
  /// Other noise, same logs: what was simulated stays.
  void useNoiseOf(const FloorResiduals& residuals) { residuals_ = &residuals; }
  [[nodiscard]] Eigen::Index size() const { return residuals_->size(); }
  [[nodiscard]] std::vector<FloorLogRows> rowsOfLogs() const;
  /// Models that were simulated so far.
  [[nodiscard]] std::size_t simulations() const { return simulations_; }

 private:
  using Key = std::vector<double>;
  [[nodiscard]] static Key keyOf(const FloorSet& set);
  void simulateMissing(const std::vector<FloorSet>& sets);

  const FloorResiduals* residuals_;
  const FloorResiduals* of_base_;  // its base traces are those of `base_`
  FloorModel base_;
  std::map<Key, FloorTraces> traces_;
  std::size_t simulations_ = 0;
};

struct FloorFit {
  FloorSet set;
  std::vector<std::vector<double>> sigmas;  // of the values; 0: not fitted
  double cost = 0;                          // robust, with the priors
  std::size_t numbers = 0;
};

/// Cost without a fit, priors included.
double costOf(const FloorSet& set, const Eigen::VectorXd& residuals);
/// Levenberg and Marquardt from the values of `set`.
FloorFit fitFloor(FloorEvaluator& evaluator, FloorSet set, int iterations);

}  // namespace darwinop::gap
