// Velocity update of a servo shaft over one step with constant external torque. Exact for viscous damping and for dry
// friction with sticking.
#pragma once

#include "twin/servo/servo.hpp"

namespace darwinop::twin {

/// J w' = torque - damping * w - friction. One object per shaft: it caches the last exponential.
class Shaft {
 public:
  /// Returns the velocity after `dt_s`. `outside_nm`: all torques except the servo's. A shaft held by friction returns
  /// exactly 0.
  double kick(double velocity_rad_s, const Actuation& servo, double outside_nm, double inertia_kgm2,
              double dt_s) noexcept;
  /// Law speed_p: motor torque in the last step, for Servo::noteMotorTorque().
  [[nodiscard]] double motorTorque() const noexcept { return motor_torque_nm_; }

 private:
  [[nodiscard]] double coast(double velocity, double torque, double friction) const noexcept;
  [[nodiscard]] double reverse(double speed, double torque, double friction) const noexcept;
  double follow(double velocity, const Actuation& servo, double outside) noexcept;

  double inertia_ = 0, damping_ = -1, dt_ = 0;
  double decay_ = 1;  // factor on the velocity over dt
  double gain_ = 0;   // velocity change per constant torque over dt
  double motor_torque_nm_ = 0;
};

}  // namespace darwinop::twin
