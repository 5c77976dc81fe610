// The measured state of a joint at a row of a log.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Position and speed at a row: a parabola through the rows around it.
struct RowState {
  double position_rad, speed_rad_s;
};
RowState stateAt(const Trajectory& log, std::size_t row);

/// Reading of one column of the log; the last before where it is NaN and readings of `name` ("volt") are masked. A
/// column of which nothing is masked is NaN where it was not read.
double lastReading(const Trajectory& log, const std::vector<double>& column, std::string_view name, std::size_t row);

/// Position of a row: measured, or where it is masked on a straight line between its neighbours.
double knownPosition(const Trajectory& log, std::size_t row);

/// Goal that the joint has been held at before the first row. None: it was limp, or a host that commands before it
/// reads starts from rest.
std::optional<double> heldBefore(const Trajectory& log, GoalOrder order);

/// Where the joint was before the log began: mean of the first readings, up to the first new command and to the first
/// position that differs by more than `resolution_rad`. NaN: no position is known.
double restBefore(const Trajectory& log, double resolution_rad);

}  // namespace darwinop::gap
