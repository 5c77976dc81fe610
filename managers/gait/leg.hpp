// Leg inverse kinematics: joint angles from the place of the sole, with the flaw that gaits were tuned on, or without.
#pragma once

#include <optional>

#include "managers/gait/stride.hpp"

namespace darwinop::gait {

/// Angles in rad, about the axes of the leg, before the servos' directions.
struct Leg {
  double hip_yaw, hip_roll, hip_pitch, knee, ankle_pitch, ankle_roll;
};

/// Nothing: the leg cannot reach that place.
///
/// The flaw: the published engine adds the identity to the rotation it takes the hip's angles from, so that it finds
/// about half of a rotation: hip roll is -1/2 of the ankle's roll instead of -1, and a foot yaw of c becomes a hip yaw
/// of c/2. Ik::kExact puts the sole where it was asked for.
std::optional<Leg> legFor(const Foot& foot, Ik ik);

}  // namespace darwinop::gait
