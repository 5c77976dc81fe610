// The two poses that our own pages promise to end in.
#pragma once

#include <algorithm>

#include "core/conversions.hpp"
#include "managers/gait/goals.hpp"
#include "managers/motion/player.hpp"

namespace darwinop::motion {

/// The stance in which walking begins; the head looks ahead.
inline Pose stance() {
  Pose pose{};
  std::ranges::copy(gait::kStanding.tick, pose.begin());
  pose[index(Joint::kNeck)] = kTickCentre;
  pose[index(Joint::kHead)] = row(Joint::kHead).start;
  return pose;
}

/// The start pose: a robot rests in it without its servos.
inline Pose sitting() {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = kJointTable[i].start;
  return pose;
}

/// Of the last step.
inline Pose lastPose(const Page& page) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) pose[i] = page.step[page.steps - 1U].position[i + 1];
  return pose;
}

}  // namespace darwinop::motion
