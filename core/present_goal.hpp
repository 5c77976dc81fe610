// Where a joint's next goal begins when a recorded movement takes over, so that no goal jumps.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/sensors.hpp"

namespace darwinop {

// A servo with the usual P gain, 4, pulls with all it has from 256 ticks (22.5 degrees) on. A goal that is farther from
// where the joint is pulls no harder, so that one this far away is no jump, and a movement need not begin any farther.
inline constexpr double kFullPull = 256 * kRadPerTick;

/// rad. The goal that the joint has, as the robot holds it after safety and not as the controller wishes it. For a limp
/// joint where it is. When nobody knows, `wished`; and its start pose, where that is no number.
inline double presentGoal(Joint joint, const JointSensors& sensors, double wished) {
  if (!sensors.commanded.known()) {
    if (sensors.position.known()) return sensors.position.value;
    return std::isfinite(wished) ? wished : radFromTicks(row(joint).start).value;
  }
  const double goal = sensors.commanded.value, here = sensors.position.value;
  return sensors.position.known() ? std::clamp(goal, here - kFullPull, here + kFullPull) : goal;
}

}  // namespace darwinop
