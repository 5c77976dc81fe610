// Velocity profile of the set point: registers 32 (moving speed) and 73 (goal acceleration).
#pragma once

namespace darwinop::twin {

/// Moves a set point to its goal within the limits, without overshoot, and reaches it exactly. If the goal moves behind
/// the set point, it decelerates first.
class Profile {
 public:
  void stop() noexcept { velocity_ = 0; }
  /// Returns the set point one period later. Limits in rad/s and rad/s2; infinity: no limit, 0: no motion.
  double advance(double set_point_rad, double goal_rad, double speed_limit, double accel_limit, double dt_s) noexcept;

  [[nodiscard]] double velocity_rad_s() const noexcept { return velocity_; }

 private:
  double velocity_ = 0;
};

}  // namespace darwinop::twin
