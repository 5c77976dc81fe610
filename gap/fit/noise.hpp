// What differs between two runs of the same thing: how much each sample of a log may be off, and what is off together.
//
// Found by running the model itself with noise: what jumps from sample to sample goes into a standard deviation a
// sample, what drifts (a release, a stick and slip) into modes that count once, not once a sample.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/fit/discrepancy.hpp"
#include "gap/fit/load_residual.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {

struct NoiseOptions {
  int runs = 32;  // of each log
  Disturbance disturbance = {};
  std::uint64_t seed = 1;
  Discrepancy discrepancy = {};
};

/// Residuals of one log in units of its noise: positions, then loads. Independent, of variance 1, where the model is
/// right. A sample that is not known counts as 0.
class LogNoise {
 public:
  LogNoise(const Case& given, std::size_t log, const Hypothesis& hypothesis, const NoiseOptions& options);

  /// `simulated`: without disturbance. `out` has size() elements.
  void residuals(const Trajectory& measured, const Trace& simulated, Eigen::Ref<Eigen::VectorXd> out) const;
  [[nodiscard]] Eigen::Index size() const { return 2 * position_sigma_.size(); }
  /// Of the covariance: what a hypothesis pays for calling a thing noise. Comparable between hypotheses on one log.
  [[nodiscard]] double logDeterminant() const;
  /// Standard deviation of each position, rad, modes included: below it nothing is a gap.
  [[nodiscard]] Eigen::VectorXd positionSigma() const;

 private:
  void addDiscrepancy(const Discrepancy& discrepancy, std::size_t log, double period_s);

  LoadResidual load_residual_;
  double correlated_samples_ = 0;  // samples that count as one, where the model leaves much unexplained; 0: it need not
  Eigen::VectorXd position_sigma_, load_sigma_;  // of what is independent; infinite: not counted
  Eigen::MatrixXd modes_;                        // orthonormal columns, in units of the sigmas
  Eigen::VectorXd mode_sigma_;                   // of each mode, same units
};

/// Of the logs with these indices.
std::vector<LogNoise> noiseOf(const Case& given, const std::vector<std::size_t>& logs, const Hypothesis& hypothesis,
                              const NoiseOptions& options);

}  // namespace darwinop::gap
