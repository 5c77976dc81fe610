// Soles of the robot, and the slope of the floor.
#pragma once

#include <mujoco/mujoco.h>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {

/// Multiplies length and width of both soles.
void scaleSoles(mjModel& m, const BodyMap& map, double scale);

/// Floor turned about the world's x (forward), then about y (left). Not the floor is turned but gravity: a simulation
/// has no other reference.
void tiltFloor(mjModel& m, double about_x_rad, double about_y_rad);
/// Gravity against z again, as in a stand, whatever the slope.
void levelFloor(mjModel& m);

/// Angles of a floor that has the slope `first`, on which something has the slope `second`.
struct FloorTilt {
  double about_x_rad = 0, about_y_rad = 0;
};
FloorTilt joined(const FloorTilt& first, const FloorTilt& second);

}  // namespace darwinop::twin
