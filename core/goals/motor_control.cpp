// A controller's settings of one motor, converted to the joint command of each step.
#include "core/goals/motor_control.hpp"

#include <algorithm>

namespace darwinop::goals {
namespace {

// s. How old a reading is when the goal that follows from it reaches the servo, and then until the next one does: up to
// six cycles of 16 ms, in a controller that computes for long.
constexpr double kReadingAge = 0.1;
// s. A torque of 0 that is shorter switches no torque off: off and on again takes seven cycles of 16 ms.
constexpr double kPassingZero = 0.1;

}  // namespace

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
  available_torque_ = std::clamp(newton_meter, 0.0, kMaxTorqueNm);
}

void MotorControl::setTorque(double newton_meter) {
  torque_touched_ = true;
  if (newton_meter != 0)
    zero_for_s_ = 0;
  else if (!torque_)
    zero_for_s_ = kPassingZero;  // of a joint that held a position: limp at once
  torque_ = newton_meter;
}

JointCommand MotorControl::command(const JointSensors& seen, double usual_gain, double dt_s) {
  JointCommand out;
  if (torque_ && *torque_ == 0) zero_for_s_ += dt_s;
  const std::optional<double> requested = goal(seen);
  const bool is_end_of_range = torque_ || (position_ && std::isinf(*position_));
  if (requested) out.setGoal(is_end_of_range ? withinPull(*requested, seen, usual_gain) : Rad{*requested});
  if (acceleration_ > 0 && requested) {
    const double cruise = std::abs(velocity());
    const Rad reachable{std::clamp(*requested, low(), high())};
    out.setSpeedLimit(RadPerSec{ramp_.next(cruise, acceleration_, reachable, seen, dt_s)});
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
    if (passesZero()) return seen.position.known() ? std::optional{seen.position.value} : std::nullopt;
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

/// No farther ahead of the joint than a goal that exerts the whole torque: it would have to come back first when the
/// direction changes, and the joint would go on in the old one meanwhile.
Rad MotorControl::withinPull(double goal, const JointSensors& seen, double usual_gain) const {
  const double error = kFullDriveError / p_gain_.value_or(usual_gain) * torqueLimit() / kMaxTorqueNm;
  const double lead = error + std::abs(seen.velocity.value) * kReadingAge;
  const double here = seen.position.value;
  return Rad{lead > 0 && here == here ? std::clamp(goal, here - lead, here + lead) : goal};
}

bool MotorControl::passesZero() const {
  return torque_ && *torque_ == 0 && zero_for_s_ <= kPassingZero && availableTorque() > 0;
}

double MotorControl::torqueLimit() const {
  return torque_ ? std::min(availableTorque(), std::abs(*torque_)) : availableTorque();
}

void MotorControl::addTorque(JointCommand& command) const {
  if (!torque_touched_) return;
  const double limit = passesZero() ? kLeastTorque : torqueLimit();
  command.setTorque(limit != 0);
  if (limit != 0) command.setTorqueLimit(NewtonMeter{limit});
}

}  // namespace darwinop::goals
