// Speed limit of a joint with an acceleration: a trapezoid that rises, cruises and falls before the goal.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "core/sensors.hpp"

namespace darwinop::goals {

/// The MX-28 has no acceleration register (older firmware), so the limit is changed in every step.
class SpeedRamp {
 public:
  /// Limit for the next step towards `goal`, rad/s, at most `cruise`.
  double next(double cruise, double acceleration, Rad goal, const JointSensors& seen, double dt_s) {
    const double first = std::min(cruise, acceleration * dt_s);  // never 0, or the joint would not start
    const double distance = goal.value - seen.position.value;    // NaN: not known
    noteRest(goal, seen);
    if (std::abs(distance) <= kAtGoal) return speed_ = first;
    const double side = distance < 0 ? -1 : 1;
    if (side != side_) speed_ = 0;
    side_ = side;
    speed_ = std::min(cruise, speed_ + acceleration * dt_s);
    if (distance == distance)
      speed_ = std::clamp(std::sqrt(2 * acceleration * std::abs(distance)), first, std::max(first, speed_));
    return speed_;
  }

 private:
  static constexpr double kAtGoal = 4 * kRadPerTick;  // a servo stops within a few ticks of its goal
  static constexpr double kStandsStill = 1.5 * kRadPerSecPerCount;

  /// A joint with a load rests farther from its goal than kAtGoal: the next goal starts at rest.
  void noteRest(Rad goal, const JointSensors& seen) {
    if (goal == goal_) {
      rests_ = std::abs(seen.velocity.value) < kStandsStill;
    } else if (rests_) {
      speed_ = 0;
      rests_ = false;
    }
    goal_ = goal;
  }

  double speed_ = 0, side_ = 0;
  Rad goal_;
  bool rests_ = false;
};

}  // namespace darwinop::goals
