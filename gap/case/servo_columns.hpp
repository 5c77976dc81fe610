// The columns of one joint in a recording of the runtime, and their rows as a log of its servo. docs/logs.md lists
// them.
#pragma once

#include <cstddef>

#include "core/joints.hpp"
#include "experiments/logs/log.hpp"
#include "gap/case/case.hpp"

namespace darwinop::gap {

struct ServoColumns {
  const logs::Column *goal, *position, *load, *p_gain;
  const logs::Column *speed, *voltage, *temperature, *speed_limit;  // null: the recording does not have it
};

/// All eight, or only those of a recording of the whole robot. Throws BadInput for one that is missing or has a wrong
/// unit.
enum class NeededColumns { kAll, kLaw };
ServoColumns servoColumns(const logs::Log& log, Joint joint, NeededColumns needed);

/// Appends a row without its time. `goal_rad`: held while `commanded` is empty, which means that the joint is limp.
void appendRow(const logs::Log& log, const ServoColumns& columns, std::size_t row, double goal_rad, Trajectory& into);

}  // namespace darwinop::gap
