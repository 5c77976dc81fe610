// The two final poses of the built-in pages.
#pragma once

#include <algorithm>

#include "core/conversions.hpp"
#include "managers/gait/goals.hpp"
#include "managers/motion/player.hpp"

namespace darwinop::motion {

/// The stance of the walk, head level.
inline Pose stance() {
  Pose pose{};
  std::ranges::copy(gait::kStanding.tick, pose.begin());
  pose[index(Joint::kNeck)] = kTickCentre;
  pose[index(Joint::kHead)] = row(Joint::kHead).start;
  return pose;
}

/// The start pose, stable without torque.
inline Pose sitting() {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = kJointTable[i].start;
  return pose;
}

/// Pose of the last step.
inline Pose lastPose(const Page& page) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = page.step[page.steps - 1U].position[i + 1];
  return pose;
}

}  // namespace darwinop::motion
