// Detects a load with the wrong sign, as some servos of the robot had it until 2012 (2013 thesis, 5.3.4).
//
// The load of law voltage_p is the duty, and the duty follows the error. With the opposite sign it would push away
// from the goal: the loop would be unstable, and any effect fitted to it would be false.
#include <algorithm>
#include <cmath>

#include "gap/case/messages.hpp"
#include "gap/case/plausible.hpp"

namespace darwinop::gap {
namespace {

constexpr double kPlain = 0.03;  // of full duty: smaller ones may have either sign, by a step of the encoder
constexpr double kAlike = 2.5;  // times the duty: a mirrored load is the duty but for its sign and an error of the gain
constexpr std::size_t kFew = 50;    // rows; fewer are not enough
constexpr double kNearlyAll = 0.9;  // of them

}  // namespace

void checkLoadSign(const Trajectory& log, const std::string& file, const Case& c) {
  const twin::ServoParameters& servo = c.model.servo;
  if (servo.law != twin::Law::kVoltageP) return;
  std::size_t plain = 0, mirrored = 0;
  for (std::size_t row = 1; row < log.rows(); ++row) {
    if (log.torque_on[row] == 0 || !(std::abs(log.load[row]) > kPlain)) continue;
    // The goal that was in force at this row's read is that of the row before.
    const double asked = servo.duty_per_kp_per_rad * log.p_register * (log.goal_rad[row - 1] - log.position_rad[row]);
    const double duty = std::clamp(asked, -servo.duty_max, servo.duty_max);
    if (!(std::abs(duty) >= kPlain)) continue;
    ++plain;
    const double share = -log.load[row] / duty;
    if (share > 1 / kAlike && share < kAlike) ++mirrored;
  }
  if (plain < kFew || static_cast<double>(mirrored) < kNearlyAll * static_cast<double>(plain)) return;
  throw BadInput(file + ": load pushes as the position error requires" + messages::kLoadHasOppositeSign +
                 std::to_string(mirrored) + " of " + std::to_string(plain) +
                 " rows. Invert the sign where the log is written; positive is counter-clockwise");
}

}  // namespace darwinop::gap
