// Trapezoidal velocity profile, discretized in firmware periods.
#include "twin/servo/profile.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

constexpr double kRounding = 1e-12;  // rad, and relative to a speed step: tolerance for rounding errors

// Maximum speed, in speed steps, from which deceleration by one step per period ends within `distance`. Speed n covers
// n + (n-1) + ... + (n-k) with k = floor(n); n(n+1)/2 for an integer n.
double maxSpeedSteps(double distance) {
  const double k = std::floor(std::sqrt(0.25 + 2 * distance) - 0.5);
  return distance / (k + 1) + k / 2;
}

/// False where the speed after this period is certainly one from which the profile still stops in time: only a braking
/// set point needs the root and the divisions of maxSpeedSteps(). Speed n stops within n(n+1)/2 + 1/8 speed steps.
bool mayBrake(double speed, double step, double distance, double dt_s) {
  return speed > 0 && (speed * (speed + step) + step * step / 4) * dt_s > 2 * step * distance;
}

}  // namespace

double Profile::advance(double set_point_rad, double goal_rad, double speed_limit, double accel_limit,
                        double dt_s) noexcept {
  const double distance = goal_rad - set_point_rad;
  if (distance == 0 && velocity_ == 0) return goal_rad;
  double speed = std::min(speed_limit, std::abs(distance) / dt_s);
  if (std::isfinite(accel_limit)) {
    const double step = accel_limit * dt_s;
    if (step <= 0) return set_point_rad;
    const double present = std::copysign(velocity_, velocity_ * distance);  // towards the goal
    if (mayBrake(present + std::clamp(speed - present, -step, step), step, std::abs(distance), dt_s))
      speed = std::min(speed, step * maxSpeedSteps(std::abs(distance) / (step * dt_s)));
    const double target = std::copysign(speed, distance);
    velocity_ += std::clamp(target - velocity_, -step, step);
    if (std::abs(velocity_) < kRounding * step) velocity_ = 0;
  } else {
    velocity_ = std::copysign(speed, distance);
  }
  if (std::abs(velocity_ * dt_s - distance) < kRounding) return goal_rad;  // exactly
  return set_point_rad + velocity_ * dt_s;
}

}  // namespace darwinop::twin
