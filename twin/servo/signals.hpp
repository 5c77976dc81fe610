// What goes on inside one servo at one instant. Effects read it and change it; see effect.hpp for when.
#pragma once

#include <limits>

#include "twin/servo/parameters.hpp"

namespace darwinop::twin {

struct Signals {
  double time_s = 0;          // since reset
  double session_time_s = 0;  // of `time_s` = 0 within the session: what wears and warms follows this clock

  // Command path: what arrived over the bus, then what the controller follows.
  bool torque_on = false;
  double goal_rad = 0;
  double profile_speed_rad_s = std::numeric_limits<double>::infinity();  // limits of the goal's own motion
  double profile_accel_rad_s2 = std::numeric_limits<double>::infinity();
  double set_point_rad = 0;  // the goal after the profile

  // Controller.
  Law law = Law::kVoltageP;                // the parameters', unless an effect replaces it
  double measured_rad = 0;                 // what the encoder says
  double error_rad = 0;                    // set point - measured
  double p_register = 32;                  // register 28; Kp = p / 8
  double i_gain = 0, d_gain = 0;           // Ki (1/s), Kd (s) of the manual, both relative to Kp's scale
  double duty_offset = 0, duty_limit = 1;  // duty = clip(law + offset, limit)
  double duty = 0;                         // -1..1
  double speed_command_rad_s = 0;          // law speed_p

  // Electrics.
  double supply_v = 12, current_a = 0;
  double kt_nm_a = 0, resistance_ohm = 0, back_emf_vs_rad = 0;
  double torque_limit_nm = std::numeric_limits<double>::infinity();  // of the motor
  double temperature_c = 25;

  // Mechanics. Torques at the horn, positive counter-clockwise.
  double position_rad = 0, velocity_rad_s = 0;  // of the gear side; a bench may foresee them
  double motor_torque_nm = 0;                   // electric torque, before friction
  double external_torque_nm = 0;                // what the arm puts on the horn
  double extra_torque_nm = 0;                   // ripple and the like, added to the motor's
  double dry_friction_nm = 0;                   // most that friction holds or brakes, whatever the speed
  double damping_nms_rad = 0;                   // viscous friction

  // Gear train between motor side and horn; 0 and infinity: rigid.
  double backlash_rad = 0;  // total free play
  double flex_stiffness_nm_rad = std::numeric_limits<double>::infinity();
  double flex_damping_nms_rad = 0;
};

/// What an effect changes of the load on the horn, once, before a run.
struct LoadChange {
  double armature_kgm2 = 0;     // added to the servo's
  double mass_scale = 1;        // of what the joint carries
  double com_shift_m = 0;       // along the arm, outward
  double angle_offset_rad = 0;  // gravity acts as if the arm stood at q - offset
};

}  // namespace darwinop::twin
