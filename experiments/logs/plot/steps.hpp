// Detects steps, slow ramps and torque-off ranges in a log.
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/logs/plot/traces.hpp"

namespace darwinop::plot {

/// Rows from a new goal to the next change.
struct GoalStep {
  std::size_t begin = 0, end = 0;
  double from = 0, to = 0;  // rad
};

/// Steps of at least 0.8 of the largest one; excludes the shorter motion to the first goal.
[[nodiscard]] std::vector<GoalStep> largeSteps(const JointColumns& joint, std::size_t from_row);

/// Seconds until the joint stays within 0.05 rad (3 degrees) of the goal; NaN if it does not arrive.
[[nodiscard]] double arrival(const logs::Log& log, const JointColumns& joint, const GoalStep& step);

/// Half-open range of rows.
struct RowRange {
  std::size_t begin = 0, end = 0;
};

/// Ramps of the goal in one direction for at least 2 s below 0.2 rad/s: quasi-static. Excludes motions between poses,
/// which are faster or less than half as long as the longest ramp.
[[nodiscard]] std::vector<RowRange> slowRanges(const logs::Log& log, const JointColumns& joint);

/// Ranges with torque off.
[[nodiscard]] std::vector<RowRange> limpRanges(const JointColumns& joint, std::size_t from_row);

/// The range with the largest continuous change of the torque limit (no jumps above 0.3 N m between rows).
[[nodiscard]] RowRange torqueSlope(const JointColumns& joint);

}  // namespace darwinop::plot
