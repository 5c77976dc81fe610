// From any pose to the one that walking starts in: all joints together, gently, 8 ms a call.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/gentle_move.hpp"
#include "managers/gait/goals.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// Angles in rad, by id minus one.
using Pose = std::array<double, kWalkingJoints>;

inline Pose poseOf(const Goals& goals) {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = goals.rad(i);
  return pose;
}

class Approach : public GentleMove<kWalkingJoints> {
 public:
  /// rad/s. The joint with the longest way takes this speed on average, and half as much again in the middle. A robot
  /// that gets up from its start pose, sitting, then takes 2.7 s.
  static constexpr double kSpeed = 0.5;
  /// rad. Nearer than this is there: the sway of a stance, not worth a wait.
  static constexpr double kThere = 0.05;
  static constexpr double kLongestMs = 6000;

  Approach() = default;
  /// A joint whose `from` is not known starts at its goal.
  Approach(Pose from, const Pose& to) {
    for (std::size_t i = 0; i < kWalkingJoints; ++i)
      if (!std::isfinite(from[i])) from[i] = to[i];
    const double way = longestWay(from, to);
    GentleMove::operator=({from, to, way > kThere ? std::min(way / kSpeed * 1000, kLongestMs) : 0});
  }

  Pose next() {
    advance(kTickMs);
    Pose pose{};
    for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = at(i);
    return pose;
  }
};

}  // namespace darwinop::gait
