// Intervals of the logs whose residual energy exceeds that of noise, with a controlled false discovery rate.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gap/localize/blocks.hpp"
#include "gap/localize/residual.hpp"

namespace darwinop::gap {

struct GapInterval {
  std::string signal;  // "position", "load", "volt"
  std::string joint;   // empty: a bench
  std::string file;
  double t0_s = 0, t1_s = 0;   // of the file's clock
  std::string happens;         // "step", "reversal", "rest", "saturation", "torque off", "slow motion", "motion"
  std::optional<Block> block;  // with the worst residual there; empty: all are closed there
  double chi2 = 0;             // sum of squares in standard deviations
  double samples = 0;          // that the sum is of
  double size = 0;             // rms there, in `unit`
  std::string unit;            // "mrad", "%", "V"
  [[nodiscard]] double score() const;
};

/// The same within one series of residuals.
struct EnergyInterval {
  std::size_t first = 0, last = 0;  // samples
  double chi2 = 0;
};

/// The strongest intervals of each series, 0.1 to 2 s long, not overlapping. `time_s`: of each sample.
std::vector<std::vector<EnergyInterval>> scanEnergy(const std::vector<Eigen::VectorXd>& z,
                                                    const std::vector<std::vector<double>>& time_s);

/// At most ten; positions first, strongest first.
std::vector<GapInterval> intervalsOf(const Case& given, const std::vector<LogResidual>& residuals,
                                     const Blocks& blocks);

/// What the joint does in some rows.
std::string whatHappens(const Trajectory& log, std::size_t first, std::size_t last, const twin::ServoParameters& servo);

}  // namespace darwinop::gap
