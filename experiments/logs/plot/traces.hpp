// Extracts joints, start and end of a run, and curves from a log.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

/// The columns of one joint; null if absent or without any value.
struct JointColumns {
  std::string name;  // "Neck"; "joint" for a plain file of one joint
  const logs::Column *position = nullptr, *goal = nullptr, *load = nullptr;
  const logs::Column *requested = nullptr, *speed = nullptr, *torque = nullptr, *p_gain = nullptr, *torque_on = nullptr;
};

/// Joints with a measured position, in the order of the log.
[[nodiscard]] std::vector<JointColumns> jointsOf(const logs::Log& log);

/// Maximum minus minimum from this row on, ignoring NaN; 0 without values.
[[nodiscard]] double range(const logs::Column* column, std::size_t from_row = 0);

/// First row of the experiment: the first new goal in the state "driven". 0 for other logs.
[[nodiscard]] std::size_t startRow(const logs::Log& log);

/// One past the last row in the state "driven"; afterwards torque goes off and the robot may fall. The number of rows
/// for other logs.
[[nodiscard]] std::size_t endRow(const logs::Log& log);

/// Seconds since a row, for every row.
[[nodiscard]] std::vector<double> timeFrom(const logs::Log& log, std::size_t row);

/// A curve of y over x. Sparse values, such as a voltage once per second, are connected.
[[nodiscard]] Curve trace(std::vector<double> x, const logs::Column& y);

/// "angle [rad]"
[[nodiscard]] std::string withUnit(const std::string& name, const std::string& unit);

}  // namespace darwinop::plot
