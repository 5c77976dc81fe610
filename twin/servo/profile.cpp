// A trapezoid in whole firmware periods.
#include "twin/servo/profile.hpp"

#include <algorithm>
#include <cmath>

namespace darwinop::twin {
namespace {

constexpr double kRounding = 1e-12;  // rad, and of a step of speed: nothing that is meant

// Greatest speed, in steps of speed, from which it still stops within the way when it loses one step a period. Speed n
// goes n + (n-1) + ... + (n-k), with k the whole part of n, and the way for a whole n is n(n+1)/2.
double mostSteps(double way) {
  const double k = std::floor(std::sqrt(0.25 + 2 * way) - 0.5);
  return way / (k + 1) + k / 2;
}

}  // namespace

double Profile::advance(double set_point_rad, double goal_rad, double speed_limit, double accel_limit,
                        double dt_s) noexcept {
  const double way = goal_rad - set_point_rad;
  double speed = std::min(speed_limit, std::abs(way) / dt_s);
  if (std::isfinite(accel_limit)) {
    const double step = accel_limit * dt_s;
    if (step <= 0) return set_point_rad;
    speed = std::min(speed, step * mostSteps(std::abs(way) / (step * dt_s)));
    const double wanted = std::copysign(speed, way);
    velocity_ += std::clamp(wanted - velocity_, -step, step);
    if (std::abs(velocity_) < kRounding * step) velocity_ = 0;
  } else {
    velocity_ = std::copysign(speed, way);
  }
  if (std::abs(velocity_ * dt_s - way) < kRounding) return goal_rad;  // to the last bit
  return set_point_rad + velocity_ * dt_s;
}

}  // namespace darwinop::twin
