// Where a robot stands: poses, and the floor under them.
#pragma once

#include <mujoco/mujoco.h>

#include <array>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {

/// The start pose of core/joints.hpp, rad.
std::array<double, kJoints> startPose();

/// Trunk over the world's origin, leaning forward by `pitch_rad`, the lowest collision shape touching the floor.
/// Everything at rest; the ball stays where it is.
void placeOnFloor(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad,
                  double pitch_rad);

/// Lets the robot sink onto the floor as one stiff piece for `seconds`, then takes all speed out of it: joints keep
/// their angles, the trunk finds where it rests.
void settle(mjModel& m, mjData& d, const BodyMap& map, double seconds);

/// Height of the lowest point of the robot's collision shapes over the floor, m. Positions must be up to date.
double lowestPoint(const mjModel& m, const mjData& d, int trunk);

}  // namespace darwinop::twin
