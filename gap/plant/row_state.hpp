// The measured state of a joint at a row of a log.
#pragma once

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Position and speed at a row: a parabola through the rows around it.
struct RowState {
  double position_rad, speed_rad_s;
};
RowState stateAt(const Trajectory& log, std::size_t row);

}  // namespace darwinop::gap
