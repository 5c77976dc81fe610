// Internal state of one servo at one instant. Effects read and change it; effect.hpp states when.
#pragma once

#include <limits>

#include "twin/servo/parameters.hpp"

namespace darwinop::twin {

struct Signals {
  double time_s = 0;          // since reset
  double session_time_s = 0;  // since the session began; clock of discharge

  // Command path.
  bool torque_on = false;
  double goal_rad = 0;
  double profile_speed_rad_s = std::numeric_limits<double>::infinity();  // limits of the profile
  double profile_accel_rad_s2 = std::numeric_limits<double>::infinity();
  double set_point_rad = 0;  // output of the profile

  // Controller.
  Law law = Law::kVoltageP;                // of the parameters, unless an effect replaces it
  double measured_rad = 0;                 // encoder reading
  double error_rad = 0;                    // set point - measured
  double p_register = 32;                  // register 28; Kp = p / 8
  double i_gain = 0, d_gain = 0;           // Ki (1/s), Kd (s) of the manual, relative to the scale of Kp
  double duty_offset = 0, duty_limit = 1;  // duty = clip(law + offset, limit)
  double duty = 0;                         // -1..1
  double speed_command_rad_s = 0;          // law speed_p

  // Electrics.
  double supply_v = 12, current_a = 0;
  double kt_nm_a = 0, resistance_ohm = 0, back_emf_vs_rad = 0;
  double torque_limit_nm = std::numeric_limits<double>::infinity();  // of the motor
  double temperature_c = kRoomC;

  // Mechanics. Torques at the horn, positive counter-clockwise.
  double position_rad = 0, velocity_rad_s = 0;  // of the gear side; on a bench, mid-step predictions
  double motor_torque_nm = 0;                   // electric torque, before friction
  double external_torque_nm = 0;                // of the arm on the horn
  double extra_torque_nm = 0;                   // added to the motor torque, e.g. ripple
  double dry_friction_nm = 0;                   // maximum friction torque, independent of speed
  double damping_nms_rad = 0;                   // viscous friction

  // Transmission between motor side and arm; 0 and infinity: rigid.
  double backlash_rad = 0;  // total free play
  double flex_stiffness_nm_rad = std::numeric_limits<double>::infinity();
  double flex_damping_nms_rad = 0;
};

/// Changes of the load on the horn by an effect, applied once before a run.
struct LoadChange {
  double armature_kgm2 = 0;     // added to the servo's
  double mass_scale = 1;        // factor on the mass of the load
  double com_shift_m = 0;       // along the arm, positive outward
  double angle_offset_rad = 0;  // gravity acts as at q - offset
};

}  // namespace darwinop::twin
