#include "gap/fit/discrepancy.hpp"

#include <cmath>

#include "gap/case/median.hpp"
#include "gap/fit/load_residual.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kOfMedian = 1.4826;  // standard deviation of a normal distribution over its median |deviation|

double spreadOf(const std::vector<double>& sizes) {
  return sizes.empty() ? 0 : kOfMedian * medianOf(sizes);
}

}  // namespace

Discrepancy discrepancyOf(const Plant& plant, const Case& given, const std::vector<std::size_t>& logs,
                          const Hypothesis& hypothesis) {
  Discrepancy discrepancy{.position_rad = 0,
                          .load = std::vector<double>(given.logs.size(), 0),
                          .correlation_s = thresholds::kDiscrepancyTime};
  std::vector<double> positions;
  Trace trace;
  for (const std::size_t index : logs) {
    const Trajectory& log = given.logs[index];
    const LoadResidual load_residual{hypothesis, log.p_register};
    plant.rollOut(given, index, hypothesis, {}, trace);
    double squares = 0, count = 0;
    for (std::size_t row = 0; row < log.rows(); ++row) {
      if (std::isnan(log.position_rad[row])) continue;  // masked
      positions.push_back(std::abs(log.position_rad[row] - trace[kPositionSignal][row]));
      const double load =
          load_residual(log.load[row], log.position_rad[row], trace[kLoadSignal][row], trace[kPositionSignal][row]);
      if (log.torque_on[row] != 0 && std::isfinite(load)) squares += load * load, ++count;
    }
    discrepancy.load[index] = count > 0 ? std::sqrt(squares / count) : 0;
  }
  discrepancy.position_rad = spreadOf(positions);
  return discrepancy;
}

double softened(double residual) {
  const double share = residual / thresholds::kDiscrepancyRobustSigmas;
  return std::copysign(thresholds::kDiscrepancyRobustSigmas * std::sqrt(2 * (std::sqrt(1 + share * share) - 1)),
                       residual);
}

}  // namespace darwinop::gap
