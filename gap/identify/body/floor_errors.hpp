// How well a model predicts recordings on the floor that no fit has used.
#pragma once

#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

/// Rms of the residuals on held-out logs on the floor: joints in rad, sensors in their units. NaN: there are none.
struct FloorErrors {
  double joints = 0, gyro = 0, accel = 0;
};

FloorErrors heldOutFloor(const BodyCase& given, const MovingImu& imu, const FloorModel& model);
/// Geometric mean of the ratios; NaN: nothing is held out.
double riseOf(const FloorErrors& after, const FloorErrors& before);

/// False: held-out logs show that the names stand for something else. More than kRemainingFloors remain, and more than
/// kHopelessGapShare of the gap. `by_gyro`: only sensors deviate, which no joint shows.
bool isVerified(const FloorErrors& before, const FloorErrors& after, bool by_gyro);

}  // namespace darwinop::gap
