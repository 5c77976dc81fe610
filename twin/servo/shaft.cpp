// Closed-form velocity update under constant torque, viscous damping and dry friction.
#include "twin/servo/shaft.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

// (1 - exp(-x)) / x; by its series for small x (error 3e-15), which is the usual case.
double meanDecay(double x) {
  constexpr double kSmall = 1.0 / 64;
  if (x > kSmall) return -std::expm1(-x) / x;
  return 1 - x * (1.0 / 2 - x * (1.0 / 6 - x * (1.0 / 24 - x * (1.0 / 120 - x * (1.0 / 720)))));
}

}  // namespace

double Shaft::kick(double velocity_rad_s, const Actuation& servo, double outside_nm, double inertia_kgm2,
                   double dt_s) noexcept {
  if (servo.damping_nms_rad != damping_ || inertia_kgm2 != inertia_ || dt_s != dt_) {
    damping_ = servo.damping_nms_rad;
    inertia_ = inertia_kgm2;
    dt_ = dt_s;
    const double x = damping_ * dt_ / inertia_, mean = meanDecay(x);
    decay_ = 1 - x * mean;
    gain_ = dt_ / inertia_ * mean;
  }
  if (servo.follows_speed) return follow(velocity_rad_s, servo, outside_nm);
  return coast(velocity_rad_s, servo.torque_nm + outside_nm, servo.friction_nm);
}

double Shaft::coast(double velocity, double torque, double friction) const noexcept {
  const double side = std::copysign(1.0, velocity == 0 ? torque : velocity);
  const double after = velocity * decay_ + (torque - side * friction) * gain_;
  if (after * side >= 0) return after;
  // It is at rest or comes to rest within the step; then friction holds it, or the torque reverses it.
  if (std::abs(torque) <= friction) return 0;
  return std::copysign(reverse(std::abs(velocity), std::abs(torque), friction), torque);
}

// Speed at the end of a step in which the torque first stops and then reverses the shaft. All arguments are magnitudes.
double Shaft::reverse(double speed, double torque, double friction) const noexcept {
  const double braking = torque + friction;
  const double rate = damping_ / inertia_;
  const double x = damping_ * speed / braking;
  const double stopped_at = x < 1e-8 ? speed * inertia_ / braking : std::log1p(x) / rate;
  const double remaining_s = std::max(0.0, dt_ - stopped_at);
  return (torque - friction) * remaining_s / inertia_ * meanDecay(rate * remaining_s);
}

// Uses the torque that reaches the target speed at the end of the step, up to the maximum torque.
double Shaft::follow(double velocity, const Actuation& servo, double outside) noexcept {
  const double speed = servo.speed_rad_s, other = servo.torque_nm + outside, friction = servo.friction_nm;
  double needed = (speed - velocity * decay_) / gain_ - other;
  if (speed != 0)
    needed += std::copysign(friction, speed);
  else  // friction assists stopping and holding
    needed = std::copysign(std::max(0.0, std::abs(needed) - friction), needed);
  motor_torque_nm_ = std::clamp(needed, -servo.speed_torque_nm, servo.speed_torque_nm);
  if (motor_torque_nm_ == needed) return speed;
  const double after = coast(velocity, other + motor_torque_nm_, friction);
  return (speed - velocity) * (speed - after) < 0 ? speed : after;
}

}  // namespace darwinop::twin
