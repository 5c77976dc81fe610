// The model's control law at one row of a recording.
#pragma once

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// Duty of law voltage_p in the last firmware cycle before the reading of row `row`, with the goal and gain that were
/// written last before it, at this encoder position. 0 where the joint is limp.
double lawAt(const BodyCase& given, const Trajectory& joint, std::size_t row, double position_rad);

/// The same with the goal and gain of the row in which they were `written`.
double lawOf(const BodyCase& given, const Trajectory& joint, std::size_t written, double position_rad);

}  // namespace darwinop::gap
