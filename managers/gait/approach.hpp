// Smooth motion of all joints from any pose to the stance of the walk, 8 ms per call.
#pragma once

#include <array>
#include <cmath>

#include "core/goals/gentle_move.hpp"
#include "managers/gait/goals.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// Angles in rad, index: servo id - 1.
using Pose = std::array<double, kWalkingJoints>;

inline Pose poseOf(const Goals& goals) {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = goals.rad(i);
  return pose;
}

class Approach : public goals::GentleMove<kWalkingJoints> {
 public:
  /// rad/s, mean speed of the joint with the longest distance; the peak is 1.5 times that, 0.75 rad/s. From the start
  /// pose: 2.7 s.
  static constexpr double kSpeed = 0.5;
  /// rad. Distances below this count as arrived.
  static constexpr double kTolerance = 0.05;

  Approach() = default;
  /// A joint with a NaN in `from` starts at its goal.
  Approach(Pose from, const Pose& to) {
    for (std::size_t i = 0; i < kWalkingJoints; ++i)
      if (!std::isfinite(from[i])) from[i] = to[i];
    const double distance = longestDistance(from, to);
    GentleMove::operator=({from, to, distance > kTolerance ? distance / kSpeed * 1000 : 0});
  }

  Pose next() {
    advance(kTickMs);
    Pose pose{};
    for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = at(i);
    return pose;
  }
};

}  // namespace darwinop::gait
