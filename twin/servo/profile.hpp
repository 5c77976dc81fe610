// The motion of the goal itself: registers 32 (moving speed) and 73 (goal acceleration).
#pragma once

namespace darwinop::twin {

/// Moves a set point to its goal, never faster than the limits allow, without overshoot, and arrives exactly. A goal
/// that jumps behind a moving set point is turned to by braking first.
class Profile {
 public:
  void stop() noexcept { velocity_ = 0; }
  /// The set point one period later. Limits in rad/s and rad/s2; infinity: none. With a limit of 0 it does not move.
  double advance(double set_point_rad, double goal_rad, double speed_limit, double accel_limit, double dt_s) noexcept;

  [[nodiscard]] double velocity_rad_s() const noexcept { return velocity_; }

 private:
  double velocity_ = 0;
};

}  // namespace darwinop::twin
