// Rotor against arm.
#include "twin/servo/transmission.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

// Teeth that meet. Stiffer than any joint of this family bends (2..300 N m/rad), so that it does not show: 1 N m is
// 1 mrad. The damping takes about a third of the speed out of an impact of 0.002 kg m2.
constexpr double kToothStiffness = 1000;  // N m/rad
constexpr double kToothDamping = 0.4;     // N m s/rad

// Angle that a sub-step may make of the fastest swing; a central scheme is off by the 24th part of its square.
constexpr double kFinest = 0.25;
// Share of a velocity difference that a sub-step may damp away.
constexpr double kMostDamped = 0.25;
constexpr int kMostSteps = 1000;
constexpr double kLightest = 1e-6;  // kg m2; a body without inertia has no motion of its own to integrate

struct Spring {
  double stiffness, damping;
};
Spring spring(const Signals& s) {
  if (std::isfinite(s.flex_stiffness_nm_rad)) return {s.flex_stiffness_nm_rad, s.flex_damping_nms_rad};
  return {kToothStiffness, kToothDamping};
}

double beyondPlay(double twist, double play) {
  return twist - std::clamp(twist, -play / 2, play / 2);
}

}  // namespace

void Transmission::reset(double position_rad, double velocity_rad_s, double rotor_kgm2) noexcept {
  position_ = position_rad;
  velocity_ = velocity_rad_s;
  rotor_kgm2_ = std::max(rotor_kgm2, kLightest);
}

Transmission::Touch Transmission::touch(const Signals& s, double gear, double gear_speed, double arm,
                                        double arm_speed) const noexcept {
  const double bend = beyondPlay(gear - arm, s.backlash_rad);
  if (s.backlash_rad > 0 && bend == 0) return {0, 0};
  const auto [stiffness, damping] = spring(s);
  const double torque = stiffness * bend + damping * (gear_speed - arm_speed);
  if (s.backlash_rad > 0 && torque * bend < 0) return {bend, 0};  // teeth push, they do not pull
  return {bend, torque};
}

int Transmission::stepsFor(const Signals& s, double arm_kgm2, double dt_s) const noexcept {
  const auto [stiffness, damping] = spring(s);
  const double lightness = 1 / rotor_kgm2_ + 1 / std::max(arm_kgm2, kLightest);
  const double steps =
      std::max(std::sqrt(stiffness * lightness) * dt_s / kFinest, damping * lightness * dt_s / kMostDamped);
  return static_cast<int>(std::clamp(std::ceil(steps), 1.0, double{kMostSteps}));
}

double Transmission::step(Servo& servo, const ArmMotion& arm, double dt_s) noexcept {
  const Signals& s = servo.signals();
  const int steps = stepsFor(s, arm.inertia_kgm2, dt_s);
  const double h = dt_s / steps, arm_kgm2 = std::max(arm.inertia_kgm2, kLightest);
  double arm_rad = arm.position_rad, arm_speed = arm.velocity_rad_s, sum = 0;
  for (int i = 0; i < steps; ++i) {
    position_ += velocity_ * h / 2;
    arm_rad += arm_speed * h / 2;
    const Touch touching = touch(s, position_, velocity_, arm_rad, arm_speed);
    // A gear that turns freely within its play carries nothing of the arm's load.
    const Actuation actuation = servo.actuate(position_, velocity_, touching.torque_nm == 0 ? 0 : arm.outside_nm);
    velocity_ = shaft_.kick(velocity_, actuation, -touching.torque_nm, rotor_kgm2_, h);
    if (actuation.follows_speed) servo.noteMotorTorque(shaft_.motorTorque());
    arm_speed += (arm.outside_nm + touching.torque_nm) / arm_kgm2 * h;
    position_ += velocity_ * h / 2;
    arm_rad += arm_speed * h / 2;
    sum += touching.torque_nm;
  }
  return sum / steps;
}

double Transmission::encoderRad(const Signals& s, double arm_rad) const noexcept {
  if (!std::isfinite(s.flex_stiffness_nm_rad)) return arm_rad;
  return arm_rad + beyondPlay(position_ - arm_rad, s.backlash_rad);
}

double Transmission::energy_j(const Signals& s, double arm_rad) const noexcept {
  const double bend = beyondPlay(position_ - arm_rad, s.backlash_rad);
  return (rotor_kgm2_ * velocity_ * velocity_ + spring(s).stiffness * bend * bend) / 2;
}

}  // namespace darwinop::twin
