// Run-to-run noise of a log: variance of each sample, and correlated modes.
//
// Estimated by simulating the model with noise. What varies from sample to sample becomes a standard deviation of the
// sample; what varies slowly (a release, stick and slip) becomes modes that count once, not once a sample.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

#include "gap/fit/discrepancy.hpp"
#include "gap/fit/load_residual.hpp"
#include "gap/plant/plant.hpp"

namespace darwinop::gap {

struct NoiseOptions {
  int runs = 32;  // of each log
  Disturbance disturbance = {};
  std::uint64_t seed = 1;
  Discrepancy discrepancy = {};
};

/// Sum of squares over rows.
struct RmsSum {
  double squares = 0, rows = 0;

  void add(const RmsSum& other) { squares += other.squares, rows += other.rows; }
  [[nodiscard]] double rms() const { return std::sqrt(squares / rows); }  // NaN without rows
};

/// Whitened residuals of one log: positions, then loads. Independent with variance 1 if the model is right. A missing
/// sample is 0.
class LogNoise {
 public:
  LogNoise(const Plant& plant, const Case& given, std::size_t log, const Hypothesis& hypothesis,
           const NoiseOptions& options);

  /// `simulated`: without disturbance. `out` has size() elements.
  void residuals(const Trajectory& measured, const Trace& simulated, Eigen::Ref<Eigen::VectorXd> out) const;
  [[nodiscard]] Eigen::Index size() const { return 2 * position_sigma_.size(); }
  /// Of the covariance; makes costs under different noise comparable.
  [[nodiscard]] double logDeterminant() const;
  /// Standard deviation of each position, rad, modes included. Infinite: it was not measured.
  [[nodiscard]] Eigen::VectorXd positionSigma() const;
  /// Of the positions that were measured, rad.
  [[nodiscard]] RmsSum positionFloor() const;
  /// The measured repeats of this log come to rest in different places, which counts as noise.
  [[nodiscard]] bool bifurcates() const { return bifurcates_; }

 private:
  void addDiscrepancy(const Discrepancy& discrepancy, std::size_t log, double period_s);

  LoadResidual load_residual_;
  bool bifurcates_ = false;
  double correlated_samples_ = 0;                // samples that count as one under a discrepancy; 0: none
  Eigen::VectorXd position_sigma_, load_sigma_;  // independent part; infinite: not counted
  Eigen::MatrixXd modes_;                        // orthonormal columns, in units of the sigmas
  Eigen::VectorXd mode_sigma_;                   // of each mode, same units
};

/// One for each of the logs with these indices.
std::vector<LogNoise> noiseOf(const Plant& plant, const Case& given, const std::vector<std::size_t>& logs,
                              const Hypothesis& hypothesis, const NoiseOptions& options);

}  // namespace darwinop::gap
