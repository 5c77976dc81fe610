#include "gap/export/fields.hpp"

#include <algorithm>
#include <cmath>

#include "gap/plant/registers.hpp"

namespace darwinop::gap {

WebotsFields webotsFields(const ServoNumbers& servo) {
  WebotsFields out;
  out.max_velocity = servo.top_speed_rad_s;
  if (std::isfinite(servo.top_accel_rad_s2)) out.acceleration = servo.top_accel_rad_s2;
  out.max_torque = servo.top_torque_nm;
  out.p = servo.speed_per_error_1_s;
  out.i = servo.integral_1_s2;
  out.d = servo.derivative;
  out.damping_constant = servo.damping_nms_rad;
  out.static_friction = servo.dry_friction_nm;
  out.gap = servo.play_rad;
  out.resolution = servo.encoder_step_rad;
  return out;
}

MujocoFields mujocoFields(const ServoNumbers& servo, double load_kgm2, double timestep_s) {
  MujocoFields out;
  out.timestep = timestep_s;
  out.armature = servo.armature_kgm2;
  out.damping = servo.damping_nms_rad;
  out.frictionloss = servo.dry_friction_nm;
  out.force = servo.top_torque_nm;
  if (servo.p_on_torque) {
    out.kp = servo.stiffness_nm_rad;
    out.kd = servo.derivative_nms_rad;
    out.back_emf = servo.braking_nms_rad;
  } else {
    // Half of a speed error goes in one step: firmer, and an explicit step begins to ring.
    constexpr double kFirm = 0.5;
    out.kd = kFirm * (servo.armature_kgm2 + load_kgm2) / timestep_s;
    out.kp = out.kd * servo.speed_per_error_1_s;
  }
  out.gain = out.kp * servo.goal_scale;
  if (std::isfinite(servo.flex_nm_rad)) {
    out.stiffness = servo.flex_nm_rad;
    out.flex_damping = servo.flex_nms_rad;
  } else {
    out.play = servo.play_rad;
  }
  constexpr double kLeast = 1e-5;  // kg m2: a gear side that moves by itself has to have some inertia
  if (out.twoHinges()) out.armature = std::max(out.armature, kLeast);
  out.sensor_noise = servo.encoder_step_rad * kRoundingSigma;
  return out;
}

UrdfFields urdfFields(const ServoNumbers& servo) {
  return {.damping = servo.damping_nms_rad,
          .friction = servo.dry_friction_nm,
          .effort = servo.top_torque_nm,
          .velocity = servo.top_speed_rad_s};
}

}  // namespace darwinop::gap
