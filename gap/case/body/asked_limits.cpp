#include "gap/case/body/asked_limits.hpp"

#include <cmath>

#include "core/servo_limits.hpp"

namespace darwinop::gap {
namespace {

constexpr double kAtLimit = 0.95;  // of the limit: a load is read with noise and in steps

const logs::Column* columnOf(const logs::Log& recording, Joint joint, const char* name) {
  return recording.find(std::string{row(joint).name} + name);
}

BadInput refused(const logs::Log& recording, const logs::Column& column, std::size_t row, const char* why) {
  return BadInput{recording.file + ", line " + std::to_string(recording.lines[row]) + ": " + column.name + " " + why};
}

/// A limit of row k acts from its command on.
bool limitsTorque(const Trajectory& rows, std::size_t row, double limit_nm) {
  if (rows.torque_on[row] == 0 || !(limit_nm < kMaxTorqueNm * kAtLimit) || row + 1 >= rows.rows()) return false;
  return std::abs(rows.load[row + 1]) >= kAtLimit * limit_nm / kMaxTorqueNm;
}

bool limitsSpeed(const Trajectory& rows, std::size_t row, double limit_rad_s) {
  if (row == 0 || rows.torque_on[row] == 0) return false;
  return std::abs(rows.goal_rad[row] - rows.goal_rad[row - 1]) >
         limit_rad_s * (rows.time_s[row] - rows.time_s[row - 1]);
}

}  // namespace

double speedLimitOf(const logs::Log& recording, Joint joint) {
  const logs::Column* const column = columnOf(recording, joint, ".asked_speed");
  if (column == nullptr) return 0;
  double found = 0;
  for (const double limit : column->values) {
    if (std::isnan(limit)) continue;
    if (found != 0 && found != limit) return 0;
    found = limit;
  }
  return found;
}

void refuseActiveLimits(const logs::Log& recording, Joint joint, const Trajectory& rows) {
  const logs::Column* const torque = columnOf(recording, joint, ".asked_torque");
  const logs::Column* const speed = rows.speed_limit_rad_s > 0 ? nullptr : columnOf(recording, joint, ".asked_speed");
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    if (torque != nullptr && limitsTorque(rows, row, torque->values[row]))
      throw refused(recording, *torque, row, messages::kTorqueLimitActs);
    if (speed != nullptr && limitsSpeed(rows, row, speed->values[row]))
      throw refused(recording, *speed, row, messages::kSpeedLimitChanges);
  }
}

}  // namespace darwinop::gap
