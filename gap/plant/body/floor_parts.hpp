// The twin's body under a hypothesis: masses, floor, soles, and the pose in which a recording begins.
#pragma once

#include "gap/plant/body/floor_roll_out.hpp"
#include "twin/body/mujoco_model.hpp"

namespace darwinop::gap {

/// Not yet with the load changes of servo effects, which JointTorques makes. Throws std::runtime_error.
twin::MjModelPtr bodyOf(const twin::Model& model, const FloorHypothesis& hypothesis);

/// At rest with these joint angles. `lies_on` empty: soles level, lowest point on the floor; else the trunk
/// horizontal on its back, front, left or right.
void placeAtRest(const mjModel& m, mjData& d, const twin::BodyMap& map, const std::array<double, kJoints>& angles_rad,
                 std::string_view lies_on);

}  // namespace darwinop::gap
