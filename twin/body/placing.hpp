// Places the robot on the floor.
#pragma once

#include <mujoco/mujoco.h>

#include <array>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {

/// The start pose of core/joints.hpp, rad.
std::array<double, kJoints> startPose();

/// Joint angles, rad; no speeds, no forces from outside. The trunk stays where it is; the ball is not touched.
void bringToRest(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad);

/// Trunk above the world's origin, pitched forward by `pitch_rad`, lowest collision geom at floor height, velocities 0.
/// The ball is not moved.
void placeOnFloor(const mjModel& m, mjData& d, const BodyMap& map, const std::array<double, kJoints>& angles_rad,
                  double pitch_rad);

/// Simulates `seconds` with fixed joints, so that the trunk comes to rest on the floor, then sets all velocities to 0.
void settleOnFloor(mjModel& m, mjData& d, const BodyMap& map, double seconds);

/// Height of the lowest point of the robot's collision geoms above the floor, m. Requires current kinematics.
double lowestPoint(const mjModel& m, const mjData& d, int trunk);

}  // namespace darwinop::twin
