// Parameters of one servo without effects: control law, motor, gear, encoder.
#pragma once

#include <limits>

#include "core/servo_limits.hpp"

namespace darwinop::twin {

/// degC. Temperature of the room, and of a servo where nothing says otherwise.
inline constexpr double kRoomC = 25;

/// Control law: what the P gain acts on.
enum class Law {
  kVoltageP,  // real servo: P sets the bridge duty, so a loaded joint has a steady-state error
  kSpeedP,    // Webots: P sets a velocity, which the motor reaches with up to its maximum torque
};

/// Defaults: MX-28 data sheet at 12 V. Friction is an effect.
struct ServoParameters {
  Law law = Law::kVoltageP;
  double firmware_period_s = 0.001;  // of the position loop; measured on benches of this servo family
  double ticks_per_rev = 4096;       // encoder

  // Law voltage_p. Motor torque = kt * current; current = (duty * supply - back_emf * velocity) / resistance.
  double kt_nm_a = kMaxTorqueNm / kStallCurrent;           // stall torque / stall current
  double resistance_ohm = kNominalSupply / kStallCurrent;  // supply / stall current
  double back_emf_vs_rad =
      kMaxTorqueNm / kStallCurrent;    // ideal motor: equal to kt; docs/twin/servo.md explains the model file's value
  double supply_v = kNominalSupply;    // without a board that sets it
  double duty_per_kp_per_rad = 0.158;  // duty per unit of the P register (28) and rad of error
  double duty_max = 1;
  double armature_kgm2 = 0.003;  // rotor and gears, reflected to the horn (193:1)

  // Law speed_p.
  double speed_gain_per_kp_1_s = kGainPerCount;  // rad/s per unit of the P register and rad of error: P = register / 8
  double speed_max_rad_s = kMaxVelocity;
  double torque_max_nm = kMaxTorqueNm;
  double accel_max_rad_s2 = std::numeric_limits<double>::infinity();  // of the commanded velocity

  // Thermal model of winding and case.
  double ambient_c = kRoomC, heat_resistance_k_w = 8, heat_capacity_j_k = 60;
  // Overload: at least this fraction of the torque limit for this long.
  double overload_share = 0.98, overload_time_s = 2;
};

}  // namespace darwinop::twin
