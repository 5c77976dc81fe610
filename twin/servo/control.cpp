// Position control loop of one servo: profile, then law voltage_p or speed_p.
#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "twin/servo/servo.hpp"

namespace darwinop::twin {

// Law voltage_p follows a profile. Law speed_p (Webots) has none: its speed and acceleration limits act on the motor.
void Servo::followGoal(double dt_s) noexcept {
  Signals& s = signals_;
  if (!s.torque_on) {  // the next profile starts at the present position
    s.set_point_rad = s.measured_rad;
    profile_.stop();
  } else if (s.law == Law::kSpeedP) {
    s.set_point_rad = s.goal_rad;
  } else {
    s.set_point_rad =
        profile_.advance(s.set_point_rad, s.goal_rad, s.profile_speed_rad_s, s.profile_accel_rad_s2, dt_s);
  }
}

void Servo::control(const ServoDrive& drive, double dt_s) noexcept {
  Signals& s = signals_;
  s.error_rad = s.set_point_rad - s.measured_rad;
  s.p_register = drive.p_gain * kRegisterPerKp;
  s.i_gain = drive.i_gain;
  s.d_gain = drive.d_gain;
  s.duty_offset = 0;
  s.duty_limit = std::min(std::clamp(drive.torque_limit, 0.0, 1.0), parameters_.duty_max);
  for (Effect* effect : controller_) effect->controller(s, dt_s);

  if (!s.torque_on) {
    s.duty = s.speed_command_rad_s = integral_ = 0;
    was_on_ = false;
    return;
  }
  if (!was_on_) last_error_ = s.error_rad;
  was_on_ = true;
  if (s.law == Law::kVoltageP)
    applyVoltageLaw(dt_s);
  else
    applySpeedLaw(dt_s);
}

// PID on the position error sets the bridge duty.
void Servo::applyVoltageLaw(double dt_s) noexcept {
  Signals& s = signals_;
  // Ki and Kd use the scale of Kp: one unit of Kp is 8 register units.
  const double scale = kRegisterPerKp * parameters_.duty_per_kp_per_rad;
  integral_ = s.i_gain == 0 ? 0
                            : std::clamp(integral_ + s.i_gain * scale * s.error_rad * dt_s, -s.duty_limit,
                                         s.duty_limit);  // anti-windup
  const double derivative = s.d_gain == 0 ? 0 : s.d_gain * scale * (s.error_rad - last_error_) / dt_s;
  last_error_ = s.error_rad;
  const double law = parameters_.duty_per_kp_per_rad * s.p_register * s.error_rad;
  s.duty = std::clamp(law + integral_ + derivative + s.duty_offset, -s.duty_limit, s.duty_limit);
  s.speed_command_rad_s = 0;
}

void Servo::startIntegralFrom(double duty) noexcept {
  Signals& s = signals_;
  if (s.law != Law::kVoltageP || s.i_gain == 0 || !s.torque_on) return;
  integral_ = std::clamp(integral_ + duty - s.duty, -s.duty_limit, s.duty_limit);
  s.duty = std::clamp(duty, -s.duty_limit, s.duty_limit);
}

// Webots motor: P on the position error sets a speed, limited in magnitude and in rate.
void Servo::applySpeedLaw(double dt_s) noexcept {
  Signals& s = signals_;
  const double max_speed = std::min(parameters_.speed_max_rad_s, s.profile_speed_rad_s);
  const double target =
      std::clamp(parameters_.speed_gain_per_kp_1_s * s.p_register * s.error_rad, -max_speed, max_speed);
  const double step = std::min(parameters_.accel_max_rad_s2, s.profile_accel_rad_s2) * dt_s;
  s.speed_command_rad_s += std::clamp(target - s.speed_command_rad_s, -step, step);
  s.duty = integral_ = 0;
}

}  // namespace darwinop::twin
