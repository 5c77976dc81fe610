#include "gap/fit/bifurcation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "gap/case/repeat_spread.hpp"
#include "gap/thresholds.hpp"

namespace darwinop::gap {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

/// Released, and still: the positions of the last part of the log are known and differ by steps of the encoder only.
bool comesToRest(const Trajectory& log, double resolution_rad) {
  double low = kUnbounded, high = -kUnbounded;
  for (std::size_t row = log.rows(); row > 0 && log.time_s[row - 1] > log.time_s.back() - thresholds::kRestTime;
       --row) {
    if (log.torque_on[row - 1] != 0) return false;
    low = std::fmin(low, log.position_rad[row - 1]);
    high = std::fmax(high, log.position_rad[row - 1]);
  }
  return high >= low && high - low <= 2 * resolution_rad;
}

/// Heat changes friction, and with it where a joint comes to rest: that is a gap, not a bifurcation. Not if unknown.
bool haveOneTemperature(const Trajectory& one, const Trajectory& other) {
  return std::abs(one.temp_c.back() - other.temp_c.back()) <= thresholds::kSameTemperature;
}

double rangeOf(const std::vector<std::vector<double>>& runs, std::size_t row) {
  double low = kUnbounded, high = -kUnbounded;
  for (const auto& run : runs) low = std::fmin(low, run[row]), high = std::fmax(high, run[row]);
  return high - low;
}

}  // namespace

Eigen::MatrixXd bifurcationOf(const Case& given, std::size_t log, double rest_sigma_rad) {
  const Trajectory& measured = given.logs[log];
  const auto rows = static_cast<Eigen::Index>(measured.rows());
  const double resolution_rad = 2 * kPi / given.model.servo.ticks_per_rev;
  Eigen::MatrixXd none(rows, 0);
  std::vector<std::vector<double>> runs;
  std::vector<std::size_t> of_its_role;  // a held-out log has no part in the noise of a fit
  for (std::size_t i = 0; i < given.logs.size(); ++i)
    if (given.logs[i].held_out == measured.held_out) of_its_role.push_back(i);
  for (const std::vector<std::size_t>& group : repeatGroups(given, of_its_role)) {
    if (std::ranges::find(group, log) == group.end()) continue;
    for (const std::size_t run : group) {
      const Trajectory& other = given.logs[run];
      if (!comesToRest(other, resolution_rad) || !haveOneTemperature(measured, other)) return none;
      runs.push_back(alignedTo(measured, other));
    }
  }
  if (runs.empty()) return none;
  const double by_noise = thresholds::kBifurcationSigmas * std::hypot(rest_sigma_rad, resolution_rad);
  std::size_t parted = measured.rows();
  while (parted > 0 && !(rangeOf(runs, parted - 1) <= by_noise)) --parted;
  if (measured.time_s.back() - measured.time_s[std::min(parted, measured.rows() - 1)] < thresholds::kRestTime)
    return none;

  const auto count = static_cast<double>(runs.size());
  Eigen::MatrixXd deviations = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(runs.size()));
  for (std::size_t row = parted; row < measured.rows(); ++row) {
    double mean = 0;
    for (const auto& run : runs) mean += run[row] / count;
    if (std::isnan(mean)) continue;
    for (std::size_t i = 0; i < runs.size(); ++i)
      deviations(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(i)) =
          (runs[i][row] - mean) * std::sqrt(count / (count - 1));
  }
  return deviations;
}

}  // namespace darwinop::gap
