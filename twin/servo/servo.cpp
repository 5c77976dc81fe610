// Servo model: command path, encoder, motor, and the values of its registers.
#include "twin/servo/servo.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/units.hpp"

namespace darwinop::twin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLoadFilter = 0.005;  // s, of the torque feedback of law speed_p

// Rounds half to even like nearbyint(), but inline: adding 1.5 * 2^52 removes the fraction. Valid below 2^51.
double nearestTick(double ticks) {
  constexpr double kShift = 0x1.8p52;
  return (ticks + kShift) - kShift;
}

}  // namespace

Servo::Servo(const ServoParameters& parameters, std::vector<std::unique_ptr<Effect>> effects)
    : parameters_{parameters},
      effects_{std::move(effects)},
      ticks_per_rad_{parameters.ticks_per_rev / (2 * kPi)},
      rad_per_tick_{2 * kPi / parameters.ticks_per_rev},
      load_share_{1 - std::exp(-parameters.firmware_period_s / kLoadFilter)},
      speed_meter_{parameters.firmware_period_s} {
  for (const auto& effect : effects_) {
    const std::uint8_t hooks = effect->hooks();
    if ((hooks & Effect::kCommandHook) != 0) command_.push_back(effect.get());
    if ((hooks & Effect::kSensorHook) != 0) sensor_.push_back(effect.get());
    if ((hooks & Effect::kControllerHook) != 0) controller_.push_back(effect.get());
    if ((hooks & Effect::kMotorHook) != 0) motor_.push_back(effect.get());
    if ((hooks & Effect::kMechanicsHook) != 0) mechanics_.push_back(effect.get());
    if ((hooks & Effect::kLoadHook) != 0) effect->load(load_);
  }
  if (parameters.armature_kgm2 + load_.armature_kgm2 < 0)
    throw std::runtime_error("armature = " + std::to_string(parameters.armature_kgm2) +
                             " kg m2 of [servo] and change = " + std::to_string(load_.armature_kgm2) +
                             " kg m2 of [effect inertia] give a negative inertia; increase one of them");
  reset(0);
}

void Servo::reset(double position_rad, double goal_rad, double session_time_s) {
  signals_ = {};
  signals_.session_time_s = session_time_s;
  signals_.position_rad = signals_.measured_rad = position_rad;
  signals_.goal_rad = signals_.set_point_rad = goal_rad;
  signals_.law = parameters_.law;
  signals_.temperature_c = parameters_.ambient_c;
  signals_.supply_v = parameters_.supply_v;
  signals_.kt_nm_a = parameters_.kt_nm_a;
  signals_.resistance_ohm = parameters_.resistance_ohm;
  signals_.back_emf_vs_rad = parameters_.back_emf_vs_rad;
  profile_.stop();
  speed_meter_.reset(position_rad);
  overload_.reset();
  integral_ = last_error_ = followed_nm_ = reported_load_ = 0;
  was_on_ = false;
  for (const auto& effect : effects_) effect->reset(signals_);
  actuate(position_rad, 0, 0);
}

void Servo::firmware(const ServoDrive& drive, double position_rad, double velocity_rad_s) noexcept {
  const double dt = parameters_.firmware_period_s;
  Signals& s = signals_;
  s.time_s += dt;
  s.session_time_s += dt;
  s.position_rad = position_rad;
  s.velocity_rad_s = velocity_rad_s;

  s.law = parameters_.law;
  s.torque_on = drive.torque_on;
  s.goal_rad = drive.goal_rad;
  s.profile_speed_rad_s = drive.speed_limit_rad_s;
  s.profile_accel_rad_s2 = drive.accel_limit_rad_s2;
  for (Effect* effect : command_) effect->command(s, dt);

  s.measured_rad = position_rad;
  for (Effect* effect : sensor_) effect->sensor(s, dt);
  s.measured_rad = nearestTick(s.measured_rad * ticks_per_rad_) * rad_per_tick_;
  speed_meter_.update(s.measured_rad);

  followGoal(dt);
  control(drive, dt);
  s.supply_v = drive.supply_v;
  s.kt_nm_a = parameters_.kt_nm_a;
  s.resistance_ohm = parameters_.resistance_ohm;
  s.back_emf_vs_rad = parameters_.back_emf_vs_rad;
  s.torque_limit_nm = kInfinity;
  for (Effect* effect : motor_) effect->motor(s, dt);  // after control(): supply_sag needs the duty
  const double torque_per_volt = s.kt_nm_a / s.resistance_ohm;
  stall_torque_nm_ = torque_per_volt * s.duty * s.supply_v;
  braking_nms_rad_ = torque_per_volt * s.back_emf_vs_rad;

  s.temperature_c = temperatureAfter(s, parameters_, dt);
  overload_.step(s, parameters_, dt);
  followed_nm_ = s.torque_on ? followed_nm_ : 0;
  updateLoad();
}

double Servo::motorTorque(double velocity_rad_s) const noexcept {
  const Signals& s = signals_;
  if (!s.torque_on) return 0;  // bridge open: no current, no back EMF damping
  if (s.law == Law::kSpeedP) return followed_nm_;
  return stall_torque_nm_ - braking_nms_rad_ * velocity_rad_s;
}

Actuation Servo::actuate(double position_rad, double velocity_rad_s, double external_nm) noexcept {
  Signals& s = signals_;
  s.position_rad = position_rad;
  s.velocity_rad_s = velocity_rad_s;
  s.external_torque_nm = external_nm;
  s.dry_friction_nm = s.damping_nms_rad = s.extra_torque_nm = 0;
  const double unlimited = motorTorque(velocity_rad_s);
  const bool limited = std::abs(unlimited) > s.torque_limit_nm;
  s.motor_torque_nm = limited ? std::copysign(s.torque_limit_nm, unlimited) : unlimited;
  s.current_a = s.motor_torque_nm / s.kt_nm_a;
  for (Effect* effect : mechanics_) effect->mechanics(s);

  Actuation out{.torque_nm = s.extra_torque_nm, .damping_nms_rad = s.damping_nms_rad, .friction_nm = s.dry_friction_nm};
  if (!s.torque_on) return out;
  if (s.law == Law::kSpeedP) {
    out.follows_speed = true;
    out.speed_rad_s = s.speed_command_rad_s;
    out.speed_torque_nm = std::min(parameters_.torque_max_nm * s.duty_limit, s.torque_limit_nm);
  } else if (limited) {
    out.torque_nm += s.motor_torque_nm;
  } else {  // back EMF as damping, which Shaft integrates exactly
    out.torque_nm += stall_torque_nm_;
    out.damping_nms_rad += braking_nms_rad_;
  }
  return out;
}

void Servo::noteMotorTorque(double torque_nm) noexcept {
  followed_nm_ = signals_.motor_torque_nm = torque_nm;
  signals_.current_a = torque_nm / signals_.kt_nm_a;
}

// Present Load: the real servo has no torque sensor and reports the duty; Webots reports the motor torque.
void Servo::updateLoad() noexcept {
  const Signals& s = signals_;
  if (!s.torque_on)
    reported_load_ = 0;
  else if (s.law == Law::kVoltageP)
    reported_load_ = s.duty;
  else
    reported_load_ += (followed_nm_ / parameters_.torque_max_nm - reported_load_) * load_share_;
}

JointMotion Servo::report() const noexcept {
  const Signals& s = signals_;
  JointMotion motion;
  motion.position_rad = s.measured_rad;
  motion.velocity_rad_s = speed_meter_.rad_s();
  motion.load = reported_load_;
  motion.temperature_c = s.temperature_c;
  motion.supply_v = s.supply_v;
  motion.overload = overload_.tripped();
  return motion;
}

bool Servo::softGear() const noexcept {
  return signals_.backlash_rad > 0 || signals_.flex_stiffness_nm_rad < kInfinity;
}

}  // namespace darwinop::twin
