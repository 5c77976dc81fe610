// What of a log can be drawn: its joints, when its run begins, and one column over another.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiments/logs/log.hpp"
#include "experiments/logs/plot/figure.hpp"

namespace darwinop::plot {

/// The columns of one joint; null: the log has none, or never knew a value.
struct JointColumns {
  std::string name;  // "Neck"; "joint" for a plain file of one joint
  const logs::Column *position = nullptr, *goal = nullptr, *load = nullptr;
  const logs::Column *asked = nullptr, *speed = nullptr, *torque = nullptr, *p_gain = nullptr, *torque_on = nullptr;
};

/// Joints with a measured position, in the order of the log.
[[nodiscard]] std::vector<JointColumns> jointsOf(const logs::Log& log);

/// Greatest minus smallest known value from this row on; 0 when there is none.
[[nodiscard]] double range(const logs::Column* column, std::size_t from_row = 0);

/// The row at which the experiment's own time begins: the first new goal once the controller drives. 0 for a log that
/// is of no experiment.
[[nodiscard]] std::size_t startRow(const logs::Log& log);

/// One past the last row in which the controller drives: then the runtime lets go, and the robot may fall. All rows for
/// a log that is of no experiment.
[[nodiscard]] std::size_t endRow(const logs::Log& log);

/// Seconds since a row, for every row.
[[nodiscard]] std::vector<double> timeFrom(const logs::Log& log, std::size_t row);

/// A curve of y over x. Rows where a value is measured now and then only, such as a voltage once a second, are joined.
[[nodiscard]] Curve trace(std::vector<double> x, const logs::Column& y);

/// "angle [rad]"
[[nodiscard]] std::string withUnit(const std::string& name, const std::string& unit);

}  // namespace darwinop::plot
