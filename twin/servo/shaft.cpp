// Closed solutions of one kick.
#include "twin/servo/shaft.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

// (1 - exp(-x)) / x; where x is small, as in a step it mostly is, to 3e-15 by its series.
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
  // It rests, or comes to rest on the way. There friction holds it, or the torque takes it back.
  if (std::abs(torque) <= friction) return 0;
  return std::copysign(turnRound(std::abs(velocity), std::abs(torque), friction), torque);
}

// Speed the other way, after a time in which the torque first stopped it. All three are amounts.
double Shaft::turnRound(double speed, double torque, double friction) const noexcept {
  const double braking = torque + friction;
  const double rate = damping_ / inertia_;
  const double x = damping_ * speed / braking;
  const double stopped_at = x < 1e-8 ? speed * inertia_ / braking : std::log1p(x) / rate;
  const double left = std::max(0.0, dt_ - stopped_at);
  return (torque - friction) * left / inertia_ * meanDecay(rate * left);
}

// The motor takes the torque that reaches its speed at the end of the kick, or all that it has.
double Shaft::follow(double velocity, const Actuation& servo, double outside) noexcept {
  const double speed = servo.speed_rad_s, rest = servo.torque_nm + outside, friction = servo.friction_nm;
  double needed = (speed - velocity * decay_) / gain_ - rest;
  if (speed != 0)
    needed += std::copysign(friction, speed);
  else  // friction helps to stop, and then holds
    needed = std::copysign(std::max(0.0, std::abs(needed) - friction), needed);
  motor_torque_nm_ = std::clamp(needed, -servo.speed_torque_nm, servo.speed_torque_nm);
  if (motor_torque_nm_ == needed) return speed;
  const double after = coast(velocity, rest + motor_torque_nm_, friction);
  return (speed - velocity) * (speed - after) < 0 ? speed : after;
}

}  // namespace darwinop::twin
