#include "gap/plant/row_state.hpp"

#include <Eigen/Core>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "gap/thresholds.hpp"

namespace darwinop::gap {

RowState stateAt(const Trajectory& log, std::size_t row) {
  const double half = thresholds::kStateHalfWindow;
  std::size_t from = row, to = row;
  while (from > 0 && log.time_s[row] - log.time_s[from - 1] <= half) --from;
  while (to + 1 < log.rows() && log.time_s[to + 1] - log.time_s[row] <= half) ++to;
  while (to - from < 2 && to - from + 1 < log.rows()) {  // rows that are far apart: three make a parabola
    if (from > 0) --from;
    if (to + 1 < log.rows()) ++to;
  }
  const double about_rad = knownPosition(log, row);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (std::size_t i = from; i <= to; ++i) {
    if (std::isnan(log.position_rad[i])) continue;
    const double t = (log.time_s[i] - log.time_s[row]) / half;
    const Eigen::Vector3d basis{1, t, t * t};
    normal += basis * basis.transpose();
    right += basis * (log.position_rad[i] - about_rad);
  }
  normal.diagonal().array() += 1e-9;  // fewer than three rows: still solvable
  const Eigen::Vector3d fit = normal.inverse() * right;
  return {about_rad + fit[0], fit[1] / half};
}

double lastReading(const Trajectory& log, const std::vector<double>& column, std::string_view name, std::size_t row) {
  if (!std::isnan(column[row]) || std::ranges::find(log.masked, name, &MaskedReadings::column) == log.masked.end())
    return column[row];
  while (row > 0 && std::isnan(column[row])) --row;
  return column[row];
}

double knownPosition(const Trajectory& log, std::size_t row) {
  if (!std::isnan(log.position_rad[row])) return log.position_rad[row];
  std::size_t before = row, after = row;
  while (before > 0 && std::isnan(log.position_rad[before])) --before;
  while (after + 1 < log.rows() && std::isnan(log.position_rad[after])) ++after;
  const double from = log.position_rad[before], to = log.position_rad[after];
  if (std::isnan(from) || std::isnan(to)) return std::isnan(from) ? to : from;
  return from + (to - from) * (log.time_s[row] - log.time_s[before]) / (log.time_s[after] - log.time_s[before]);
}

std::optional<double> heldBefore(const Trajectory& log, GoalOrder order) {
  if (order != GoalOrder::kAfterRead) return std::nullopt;
  if (log.goal_before_rad) return log.goal_before_rad;
  return log.torque_on[0] != 0 ? std::optional{log.goal_rad[0]} : std::nullopt;
}

double restBefore(const Trajectory& log, double resolution_rad) {
  const double first = knownPosition(log, 0), before_rad = log.goal_before_rad.value_or(log.goal_rad[0]);
  double sum = 0, count = 0;
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const double position = knownPosition(log, row);
    const bool commanded = log.goal_rad[row] != before_rad || log.torque_on[row] != log.torque_on[0];
    if (row > 0 && (commanded || !(std::abs(position - first) <= resolution_rad))) break;
    sum += position, ++count;
  }
  return sum / count;
}

}  // namespace darwinop::gap
