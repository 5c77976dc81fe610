// Evaluates the twin's servo, so that no equation of an effect is repeated here.
#include "gap/export/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/conversions.hpp"
#include "core/units.hpp"
#include "gap/plant/baseline_alias.hpp"
#include "gap/plant/bench/surroundings.hpp"
#include "twin/bench/bench.hpp"
#include "twin/servo/servo.hpp"

namespace darwinop::gap {
namespace {

using Effects = std::vector<std::unique_ptr<twin::Effect>>;

Effects effectsOf(const Hypothesis& hypothesis, const double& temperature_c) {
  Effects all;
  all.push_back(std::make_unique<Surroundings>(temperature_c, nullptr, hypothesis.servo.firmware_period_s));
  for (const twin::EffectSetting& effect : hypothesis.effects) all.push_back(effect.info->make(effect.values));
  return all;
}

ServoDrive atTheGoal(const Hypothesis& hypothesis, const Conditions& conditions, bool torque_on) {
  return {.torque_on = torque_on,
          .goal_rad = 0,
          .speed_limit_rad_s = conditions.speed_limit_rad_s,
          .torque_limit = 1,
          .p_gain = conditions.p_register / kRegisterPerKp,
          .supply_v = hypothesis.servo.supply_v};
}

// At the goal there is no error: only the settings of controller and motor remain.
void takeMotor(const Hypothesis& hypothesis, const twin::Signals& s, ServoNumbers& out) {
  const twin::ServoParameters& servo = hypothesis.servo;
  const double per_duty_nm = s.kt_nm_a / s.resistance_ohm * servo.supply_v;
  const double duty_per_rad = servo.duty_per_kp_per_rad * s.p_register;
  const double unit = kRegisterPerKp * servo.duty_per_kp_per_rad;  // Ki and Kd have the scale of Kp
  out.p_on_torque = s.law == twin::Law::kVoltageP;
  out.stiffness_nm_rad = per_duty_nm * duty_per_rad;
  out.stall_nm = std::min(per_duty_nm * s.duty_limit, s.torque_limit_nm);
  out.braking_nms_rad = s.kt_nm_a / s.resistance_ohm * s.back_emf_vs_rad;
  out.integral_nm_rad_s = per_duty_nm * unit * s.i_gain;
  out.derivative_nms_rad = per_duty_nm * unit * s.d_gain;
  out.top_accel_rad_s2 = s.profile_accel_rad_s2;
  if (out.p_on_torque) {
    const double per_duty_rad_s = servo.supply_v / s.back_emf_vs_rad;
    out.speed_per_error_1_s = per_duty_rad_s * duty_per_rad;
    out.integral_1_s2 = per_duty_rad_s * unit * s.i_gain;
    out.derivative = per_duty_rad_s * unit * s.d_gain;
    out.top_torque_nm = out.stall_nm;
    const double at_full_duty_nm = per_duty_nm * s.duty_limit;  // a limit of the torque leaves the speed
    out.top_speed_rad_s =
        std::max(0.0, at_full_duty_nm - out.dry_friction_nm) / (out.braking_nms_rad + out.damping_nms_rad);
  } else {
    out.speed_per_error_1_s = servo.speed_gain_per_kp_1_s * s.p_register;
    out.top_torque_nm = std::min(servo.torque_max_nm * s.duty_limit, s.torque_limit_nm);
    out.top_speed_rad_s = servo.speed_max_rad_s;
    out.top_accel_rad_s2 = std::min(out.top_accel_rad_s2, servo.accel_max_rad_s2);
  }
  out.top_speed_rad_s = std::min(out.top_speed_rad_s, s.profile_speed_rad_s);
}

// With the motor off nothing loads the gears, and at this speed the friction of slow motion has faded.
void takeMechanics(const twin::Signals& s, ServoNumbers& out) {
  out.damping_nms_rad = s.damping_nms_rad;
  out.dry_friction_nm = s.dry_friction_nm;
  out.play_rad = s.backlash_rad;
  out.flex_nm_rad = s.flex_stiffness_nm_rad;
  out.flex_nms_rad = s.flex_damping_nms_rad;
}

}  // namespace

ServoNumbers numbersOf(const Hypothesis& hypothesis, const Conditions& conditions) {
  constexpr double kFast = 1e6;  // rad/s
  twin::Servo servo{hypothesis.servo, effectsOf(hypothesis, conditions.temperature_c)};
  ServoNumbers out;
  servo.firmware(atTheGoal(hypothesis, conditions, false), 0, 0);
  servo.actuate(0, kFast, 0);
  takeMechanics(servo.signals(), out);
  servo.firmware(atTheGoal(hypothesis, conditions, true), 0, 0);
  takeMotor(hypothesis, servo.signals(), out);
  out.armature_kgm2 = hypothesis.servo.armature_kgm2 + servo.load().armature_kgm2;
  out.goal_scale = hypothesis.value(twin::ParameterRole::kGoalFactor).value_or(1);
  const double ticks = hypothesis.servo.ticks_per_rev;
  out.encoder_step_rad =
      2 * kPi / std::min(ticks, hypothesis.value(twin::ParameterRole::kEncoderTicks).value_or(ticks));
  return out;
}

double ArmNumbers::gravityAt(double position_rad) const {
  return -weight_nm * std::sin(position_rad - hangs_at_rad);
}

ArmNumbers armOf(const Hypothesis& hypothesis, double payload_kg) {
  Hypothesis arm_alone = hypothesis;
  std::erase_if(arm_alone.effects, [](const auto& effect) { return isAliasOf(*effect.info, "armature"); });
  arm_alone.servo.armature_kgm2 = 1e-300;  // nothing beside any arm, and a bench without arm is a bench still
  twin::Pendulum pendulum = hypothesis.pendulum;
  pendulum.payload_kg = payload_kg * hypothesis.payload_scale;
  const double temperature_c = hypothesis.servo.ambient_c;
  const twin::Bench bench{arm_alone.servo, effectsOf(arm_alone, temperature_c), pendulum};
  const twin::LoadChange& change = bench.servo().load();
  ArmNumbers out;
  out.inertia_kgm2 = bench.inertia_kgm2();
  out.weight_nm = bench.weight_nm();
  out.hangs_at_rad = change.angle_offset_rad;
  out.mass_kg = (pendulum.payload_kg + pendulum.arm_mass_kg) * change.mass_scale;
  out.gravity_m_s2 = pendulum.gravity_m_s2;
  if (out.mass_kg > 0 && out.gravity_m_s2 > 0) out.com_m = out.weight_nm / out.mass_kg / out.gravity_m_s2;
  return out;
}

}  // namespace darwinop::gap
