// Pose of all joints in SI units.
#pragma once

#include "core/goals/lead_in.hpp"
#include "core/goals/present_goal.hpp"

namespace darwinop::body_player {

/// rad, by joint.
using Pose = goals::LeadIn::Pose;

/// First goals of a motion that takes over, see core/goals/present_goal.hpp. `sensors_of(joint)`: newest sensor values;
/// `requested_of(joint)`: the controller's goal in rad, used if a joint's goal and position are unknown.
template <class SensorsOf, class RequestedOf>
Pose presentPose(const SensorsOf& sensors_of, const RequestedOf& requested_of) {
  Pose pose{};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    pose[i] = goals::presentGoal(joint, sensors_of(joint), requested_of(joint));
  }
  return pose;
}

}  // namespace darwinop::body_player
