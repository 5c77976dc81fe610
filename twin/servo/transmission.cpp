// Integrates rotor and arm of a joint with backlash or elasticity.
#include "twin/servo/transmission.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

// Tooth contact. Much stiffer than the joints of this family (2 to 300 N m/rad): 1 N m is 1 mrad. The damping removes
// about a third of the speed in an impact of 0.002 kg m2.
constexpr double kToothStiffness = 1000;  // N m/rad
constexpr double kToothDamping = 0.4;     // N m s/rad

// Maximum phase of the fastest oscillation per sub-step, rad; the relative error is its square / 24.
constexpr double kMaxPhase = 0.25;
// Maximum fraction of a velocity difference that damping removes per sub-step.
constexpr double kMaxDamping = 0.25;
constexpr int kMaxSteps = 1000;
constexpr double kMinInertia = 1e-6;  // kg m2
// Minimum inertia of an arm, as a share of the rotor's, which is known to 10 % at best. A massless arm follows the
// gears anyway, but its oscillation at the teeth would set the step: 1000 sub-steps of a firmware period instead of 50.
constexpr double kMinArmShare = 0.01;

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
  rotor_kgm2_ = std::max(rotor_kgm2, kMinInertia);
}

double Transmission::rest(const Signals& s, double encoder_rad, double torque_nm, double rotor_kgm2) noexcept {
  const bool is_elastic = std::isfinite(s.flex_stiffness_nm_rad);
  const double bend = torque_nm / spring(s).stiffness, arm = is_elastic ? encoder_rad - bend : encoder_rad;
  reset(arm + bend + std::copysign(s.backlash_rad / 2, torque_nm), 0, rotor_kgm2);
  return arm;
}

double Transmission::armInertia(double arm_kgm2) const noexcept {
  return std::max(arm_kgm2, kMinArmShare * rotor_kgm2_);
}

Transmission::Contact Transmission::contact(const Signals& s, double gear, double gear_speed, double arm,
                                            double arm_speed) const noexcept {
  const double bend = beyondPlay(gear - arm, s.backlash_rad);
  if (s.backlash_rad > 0 && bend == 0) return {0, 0};
  const auto [stiffness, damping] = spring(s);
  const double torque = stiffness * bend + damping * (gear_speed - arm_speed);
  if (s.backlash_rad > 0 && torque * bend < 0) return {bend, 0};  // teeth only push
  return {bend, torque};
}

int Transmission::stepsFor(const Signals& s, double arm_kgm2, double dt_s) const noexcept {
  const auto [stiffness, damping] = spring(s);
  const double inverse_inertia = 1 / rotor_kgm2_ + 1 / armInertia(arm_kgm2);
  const double steps = std::max(std::sqrt(stiffness * inverse_inertia) * dt_s / kMaxPhase,
                                damping * inverse_inertia * dt_s / kMaxDamping);
  return static_cast<int>(std::clamp(std::ceil(steps), 1.0, double{kMaxSteps}));
}

double Transmission::step(Servo& servo, const ArmMotion& arm, double dt_s) noexcept {
  const Signals& s = servo.signals();
  const int steps = stepsFor(s, arm.inertia_kgm2, dt_s);
  const double h = dt_s / steps, arm_kgm2 = armInertia(arm.inertia_kgm2);
  double arm_rad = arm.position_rad, arm_speed = arm.velocity_rad_s, sum = 0;
  for (int i = 0; i < steps; ++i) {
    position_ += velocity_ * h / 2;
    arm_rad += arm_speed * h / 2;
    const Contact touching = contact(s, position_, velocity_, arm_rad, arm_speed);
    // Within the play the gear side carries no load.
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
