// Limits the speed of goals to that of the safety layer, so that a jump is spread over several calls.
#pragma once

#include "core/servo_limits.hpp"
#include "managers/gait/approach.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// Maximum change per call, 64 ticks. The engine demands 7.5 rad/s at the knees of a walk, 18 in one call when the feet
/// open for a sidestep or a turn, and more after a foot was out of reach.
inline constexpr double kMaxChange = kMaxVelocity * kTickMs / 1000;

/// One call from `from` towards `to`, independently per joint.
inline Pose atServoSpeed(const Pose& from, const Pose& to) {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i) {
    const double change = to[i] - from[i];
    pose[i] = change > kMaxChange ? from[i] + kMaxChange : change < -kMaxChange ? from[i] - kMaxChange : to[i];
  }
  return pose;
}

}  // namespace darwinop::gait
