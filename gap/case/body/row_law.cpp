#include "gap/case/body/row_law.hpp"

#include <algorithm>

namespace darwinop::gap {

double dutyFor(const twin::ServoParameters& servo, double p_register, double error_rad) {
  return std::clamp(servo.duty_per_kp_per_rad * p_register * error_rad, -servo.duty_max, servo.duty_max);
}

double lawAt(const BodyCase& given, const Trajectory& joint, std::size_t row, double position_rad) {
  return lawOf(given, joint, writtenBefore(joint, row), position_rad);
}

double lawOf(const BodyCase& given, const Trajectory& joint, std::size_t written, double position_rad) {
  if (joint.torque_on[written] == 0) return 0;
  return dutyFor(given.joints.model.servo, joint.pRegisterAt(written), joint.goal_rad[written] - position_rad);
}

}  // namespace darwinop::gap
