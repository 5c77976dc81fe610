// Goals move no faster than the safety layer lets them: what the engine asks for beyond that is reached a few calls
// later.
#pragma once

#include "managers/gait/approach.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// rad/s, full scale of the servo's speed register. No servo turns so fast: an MX-28 without a load at 12 V does 5.76
/// (managers/motion/first_step.hpp). The engine asks for less, 7.5, at the knees of a walk; for 18 in one call
/// when feet open for a sidestep or a turn; for anything when a foot comes back from where the leg did not reach.
inline constexpr double kServoSpeed = 12.26;
/// The way of one call, 64 ticks.
inline constexpr double kServoWay = kServoSpeed * kTickMs / 1000;

/// One call from `from` towards `to`, every joint by itself.
inline Pose atServoSpeed(const Pose& from, const Pose& to) {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i) {
    const double way = to[i] - from[i];
    pose[i] = way > kServoWay ? from[i] + kServoWay : way < -kServoWay ? from[i] - kServoWay : to[i];
  }
  return pose;
}

}  // namespace darwinop::gait
