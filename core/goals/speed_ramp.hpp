// Speed limit of a joint with an acceleration: a trapezoid that rises, cruises and falls before the goal.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"

namespace darwinop::goals {

/// The MX-28 has no acceleration register (older firmware), so the limit is changed in every step.
class SpeedRamp {
 public:
  /// Limit for the next step, rad/s, at most `cruise`. `distance` to the goal in rad, signed; NaN: not known.
  double next(double cruise, double acceleration, double distance, double dt_s) {
    const double first = std::min(cruise, acceleration * dt_s);  // never 0, or the joint would not start
    if (std::abs(distance) <= kAtGoal) return speed_ = first;
    const double side = distance < 0 ? -1 : 1;
    if (side != side_) speed_ = 0;
    side_ = side;
    speed_ = std::min(cruise, speed_ + acceleration * dt_s);
    if (distance != distance) return speed_;
    return std::clamp(std::sqrt(2 * acceleration * std::abs(distance)), first, std::max(first, speed_));
  }

 private:
  static constexpr double kAtGoal = 4 * kRadPerTick;  // a servo stops within a few ticks of its goal
  double speed_ = 0, side_ = 0;
};

}  // namespace darwinop::goals
