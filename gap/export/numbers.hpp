// A hypothesis as plain numbers: what a simulator without our effects can represent of one joint.
#pragma once

#include <limits>

#include "core/units.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// The conditions under which a hypothesis becomes constant numbers.
struct Conditions {
  double p_register = 32;                                              // register 28
  double temperature_c = twin::kRoomC;                                 // where friction and copper are taken
  double speed_limit_rad_s = std::numeric_limits<double>::infinity();  // of the servo's profile, register 32
};

/// Effects of constant numbers are in them; those that change with speed, load, angle or time are not.
struct ServoNumbers {
  bool p_on_torque = true;  // law voltage_p
  // Law voltage_p: tm = clip(stiffness * error, stall) - braking * speed.
  double stiffness_nm_rad = 0, stall_nm = 0, braking_nms_rad = 0;
  double integral_nm_rad_s = 0, derivative_nms_rad = 0;
  // As a motor that P gives a speed. Law speed_p: its own; voltage_p: the speed that the same error has without load.
  double speed_per_error_1_s = 0, integral_1_s2 = 0, derivative = 0;
  double top_speed_rad_s = 0, top_accel_rad_s2 = 0;  // infinite: no limit
  double top_torque_nm = 0;
  // Behind the motor.
  double damping_nms_rad = 0, dry_friction_nm = 0, armature_kgm2 = 0;
  double play_rad = 0;
  double flex_nm_rad = std::numeric_limits<double>::infinity(), flex_nms_rad = 0;  // infinity: rigid
  // Before and beside it.
  double goal_scale = 1;
  double encoder_step_rad = 0;
};
ServoNumbers numbersOf(const Hypothesis& hypothesis, const Conditions& conditions);

/// What the joint carries, without armature.
struct ArmNumbers {
  double inertia_kgm2 = 0;  // about the joint
  double weight_nm = 0;     // torque of gravity when it stands out sideways
  double hangs_at_rad = 0;  // encoder's reading there
  double mass_kg = 0, com_m = 0;
  double gravity_m_s2 = kGravity;

  [[nodiscard]] double gravityAt(double position_rad) const;  // N m
};
/// `payload_kg`: as weighed; the hypothesis may scale it.
ArmNumbers armOf(const Hypothesis& hypothesis, double payload_kg);

}  // namespace darwinop::gap
