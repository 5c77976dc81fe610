// Where a joint's next goal begins when a recorded movement takes over, so that no goal jumps.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "core/sensors.hpp"

namespace darwinop::facade {

// A servo with the usual P gain, 4, pulls with all it has from 256 ticks (22.5 degrees) on. A goal that is farther from
// where the joint is pulls no harder, so that one this far away is no jump, and a movement need not begin any farther.
inline constexpr double kFullPull = 256 * kRadPerTick;

/// rad. The goal that the joint has, as the robot holds it after safety and not as the controller wishes it. For a limp
/// joint where it is, and `wished` when nobody knows.
inline double presentGoal(const JointSensors& joint, double wished) {
  if (!joint.commanded.known())
    return joint.position.known() ? joint.position.value : std::isfinite(wished) ? wished : 0;
  if (!joint.position.known()) return joint.commanded.value;
  return std::clamp(joint.commanded.value, joint.position.value - kFullPull, joint.position.value + kFullPull);
}

}  // namespace darwinop::facade
