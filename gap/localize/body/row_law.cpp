#include "gap/localize/body/row_law.hpp"

#include <algorithm>

namespace darwinop::gap {

double lawAt(const BodyCase& given, const Trajectory& joint, std::size_t row, double position_rad) {
  return lawOf(given, joint, row == 0 || joint.isReadAfterWrite() ? row : row - 1, position_rad);
}

double lawOf(const BodyCase& given, const Trajectory& joint, std::size_t written, double position_rad) {
  if (joint.torque_on[written] == 0) return 0;
  const twin::ServoParameters& servo = given.joints.model.servo;
  const double duty = servo.duty_per_kp_per_rad * joint.pRegisterAt(written) * (joint.goal_rad[written] - position_rad);
  return std::clamp(duty, -servo.duty_max, servo.duty_max);
}

}  // namespace darwinop::gap
