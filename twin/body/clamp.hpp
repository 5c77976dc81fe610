// Holds the trunk in the air, as a stand does: it neither moves nor turns.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <optional>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {

/// Upward direction in the trunk's frame (left, up, forward), a unit vector.
using ClampedUp = std::array<double, 3>;

/// DARWINOP_TWIN_CLAMP, "0 1 0": x y z of the upward direction in the trunk's frame, of any length. Empty if it is not
/// set. Throws std::runtime_error for any other value.
std::optional<ClampedUp> clampFromEnvironment();

/// Makes the trunk immovable for its joints. After all other changes of the model. Throws std::runtime_error.
void clampTrunk(mjModel& m, const BodyMap& map);
/// Puts the trunk in the stand, at rest, with these joint angles.
void placeInStand(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad,
                  const ClampedUp& up);
/// Takes back what a step moved the trunk by.
void holdInStand(mjData& d, const BodyMap& map, const ClampedUp& up) noexcept;

}  // namespace darwinop::twin
