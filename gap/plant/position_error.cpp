#include "gap/plant/position_error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "gap/case/plausible.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

/// Calls add(measured - simulated, rows of the log) for every row; returns the number of logs.
template <class Add>
std::size_t overErrors(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role,
                       const Add& add) {
  std::size_t logs = 0;
  Trace trace;
  const auto copies = duplicates(data);
  for (std::size_t i = 0; i < data.logs.size(); ++i) {
    const Trajectory& log = data.logs[i];
    if (log.held_out != (role == LogRole::kHeldOut) || copies[i]) continue;
    plant.rollOut(data, i, hypothesis, {}, trace);
    const auto masked = std::ranges::count_if(log.position_rad, [](double position) { return std::isnan(position); });
    for (std::size_t row = 0; row < log.rows(); ++row)
      if (!std::isnan(log.position_rad[row]))
        add(log.position_rad[row] - trace[kPositionSignal][row], static_cast<double>(log.rows()) - double(masked));
    ++logs;
  }
  return logs;
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

double rmsPositionError(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role) {
  double sum = 0, count = 0;
  overErrors(plant, data, hypothesis, role, [&](double error, double /*rows*/) { sum += error * error, ++count; });
  return count == 0 ? kUnknown : std::sqrt(sum / count);
}

bool isWorse(double before_rad, double after_rad, double floor_rad) {
  return after_rad > thresholds::kHeldOutErrorRatio * before_rad &&
         after_rad > before_rad + thresholds::kHeldOutFloors * floor_rad;
}

double meanPositionError(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role) {
  double sum = 0;
  const std::size_t logs =
      overErrors(plant, data, hypothesis, role, [&](double error, double rows) { sum += std::abs(error) / rows; });
  return logs == 0 ? kUnknown : sum / static_cast<double>(logs);
}

}  // namespace darwinop::gap
