// How well a model predicts recordings on the floor that no fit has used.
#pragma once

#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

/// Rms of the residuals on held-out logs on the floor: joints in rad, sensors in their units. NaN: there are none.
struct FloorErrors {
  double joints = 0, gyro = 0, accel = 0;
};

FloorErrors heldOutFloor(const BodyCase& given, const MovingImu& imu, const FloorModel& model);

}  // namespace darwinop::gap
