// The model's control law at one row of a recording.
#pragma once

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// The row whose goal and gain were written last before the reading of row `row`.
inline std::size_t writtenBefore(const Trajectory& joint, std::size_t row) {
  return row == 0 || joint.isReadAfterWrite() ? row : row - 1;
}

/// Duty of law voltage_p for an error of the position, limited by the servo.
double dutyFor(const twin::ServoParameters& servo, double p_register, double error_rad);

/// Duty of law voltage_p in the last firmware cycle before the reading of row `row`, with the goal and gain that were
/// written last before it, at this encoder position. 0 where the joint is limp.
double lawAt(const BodyCase& given, const Trajectory& joint, std::size_t row, double position_rad);

/// The same with the goal and gain of the row in which they were `written`.
double lawOf(const BodyCase& given, const Trajectory& joint, std::size_t written, double position_rad);

}  // namespace darwinop::gap
