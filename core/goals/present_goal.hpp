// First goal of a joint when a motion takes over, so that no goal jumps.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/sensors.hpp"

namespace darwinop::goals {

// With the default P gain, 4, a servo's output saturates at an error of 256 ticks (22.5 degrees). A goal farther away
// than this exerts no more torque, so a motion starts at most this far from the joint.
inline constexpr double kFullPull = 256 * kRadPerTick;

/// rad. The joint's goal after safety, at most kFullPull from its position; of a limp joint, its position. If both are
/// unknown: `requested`, the controller's goal, or the start pose if that is not finite.
inline double presentGoal(Joint joint, const JointSensors& sensors, double requested) {
  if (!sensors.commanded.known()) {
    if (sensors.position.known()) return sensors.position.value;
    return std::isfinite(requested) ? requested : radFromTicks(row(joint).start).value;
  }
  const double goal = sensors.commanded.value, here = sensors.position.value;
  return sensors.position.known() ? std::clamp(goal, here - kFullPull, here + kFullPull) : goal;
}

}  // namespace darwinop::goals
