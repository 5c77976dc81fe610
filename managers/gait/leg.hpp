// Leg inverse kinematics: joint angles from the pose of the sole, exact or with the defect of the published engine.
#pragma once

#include <optional>

#include "managers/gait/stride.hpp"

namespace darwinop::gait {

/// Angles in rad about the leg's axes, before the servo signs are applied.
struct Leg {
  double hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll;
};

/// Empty if the position is out of reach.
///
/// Ik::kFlawed: the published engine adds the identity to the rotation matrix of the thigh, so it finds about half of a
/// rotation: hip roll is -1/2 of the ankle roll instead of -1, and a foot yaw of c becomes a hip yaw of c/2. Ik::kExact
/// reaches the requested pose.
std::optional<Leg> legFor(const Foot& foot, Ik ik);

}  // namespace darwinop::gait
