// A shaft that a servo turns: its velocity after a moment in which all outside torques stand still. Damping is
// integrated exactly, and so is dry friction with its sticking.
#pragma once

#include "twin/servo/servo.hpp"

namespace darwinop::twin {

/// J w' = torque - damping * w - friction. One object a shaft: it keeps the last exponential for the next time.
class Shaft {
 public:
  /// `outside_nm`: every torque but the servo's. Friction takes up to its most to bring the shaft to rest, and holds it
  /// there to the last bit.
  double kick(double velocity_rad_s, const Actuation& servo, double outside_nm, double inertia_kgm2,
              double dt_s) noexcept;
  /// Law speed_p: the torque that the motor took for the last kick. Goes into Servo::noteMotorTorque().
  [[nodiscard]] double motorTorque() const noexcept { return motor_torque_nm_; }

 private:
  [[nodiscard]] double coast(double velocity, double torque, double friction) const noexcept;
  [[nodiscard]] double turnRound(double speed, double torque, double friction) const noexcept;
  double follow(double velocity, const Actuation& servo, double outside) noexcept;

  double inertia_ = 0, damping_ = -1, dt_ = 0;
  double decay_ = 1;  // of the velocity over dt
  double gain_ = 0;   // velocity that a constant torque gives over dt
  double motor_torque_nm_ = 0;
};

}  // namespace darwinop::twin
