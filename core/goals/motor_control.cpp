// A controller's settings of one motor, converted to the joint command of each step.
#include "core/goals/motor_control.hpp"

#include <algorithm>

namespace darwinop::goals {

void MotorControl::setPosition(double rad) {
  position_ = rad;
  torque_.reset();
  held_.reset();
}

void MotorControl::setAcceleration(double rad_per_s2) {
  acceleration_ = rad_per_s2 > 0 ? rad_per_s2 : -1;
  velocity_ = velocity();  // set from now on, so that the end of a ramp restores it
}

void MotorControl::setAvailableTorque(double newton_meter) {
  torque_touched_ = true;
  available_torque_ = std::isnan(newton_meter) ? newton_meter : std::clamp(newton_meter, 0.0, kMaxTorqueNm);
}

void MotorControl::setTorque(double newton_meter) {
  torque_touched_ = true;
  torque_ = newton_meter;
}

JointCommand MotorControl::command(const JointSensors& seen, double dt_s) {
  JointCommand out;
  const std::optional<double> requested = goal(seen);
  if (requested) out.setGoal(Rad{*requested});
  if (acceleration_ > 0 && requested) {
    const double cruise = std::abs(velocity());
    const double reachable = std::clamp(*requested, low(), high());
    out.setSpeedLimit(RadPerSec{ramp_.next(cruise, acceleration_, reachable - seen.position.value, dt_s)});
  } else {
    if (acceleration_ <= 0) restartRamp();
    if (velocity_) out.setSpeedLimit(RadPerSec{std::abs(*velocity_)});
  }
  if (p_gain_) out.setPGain(*p_gain_);
  addTorque(out);
  return out;
}

std::optional<double> MotorControl::goal(const JointSensors& seen) {
  if (torque_) {
    if (*torque_ == 0) return position_ && std::isfinite(*position_) ? position_ : std::nullopt;
    return *torque_ > 0 ? low() : high();  // as in 2013: positive torque turns clockwise
  }
  if (!position_ || !std::isinf(*position_)) return position_;
  if (velocity() > 0 || velocity() < 0) {
    held_.reset();
    return velocity() > 0 ? high() : low();
  }
  if (!held_) held_ = seen.position.known() ? seen.position.value : seen.commanded.value;
  return held_;
}

void MotorControl::addTorque(JointCommand& command) const {
  if (!torque_touched_) return;
  double limit = availableTorque();
  if (torque_) limit = std::min(limit, std::abs(*torque_));
  // Only 0 switches torque off; safety rejects a limit that is not a number.
  command.setTorque(limit != 0);
  if (limit != 0) command.setTorqueLimit(NewtonMeter{limit});
}

}  // namespace darwinop::goals
