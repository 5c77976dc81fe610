// The gap of the whole robot on recordings that no fit has used: of the declared model, of the final one, and the
// noise.
#pragma once

#include "core/sensors.hpp"
#include "gap/localize/body/floor_residuals.hpp"

namespace darwinop::gap {

/// Rms of measured minus simulated samples: positions of joints in rad, sensors in their units. NaN: there are none, or
/// their simulation failed.
struct GapErrors {
  double joints = kUnknown, gyro = kUnknown, accel = kUnknown;
};

/// Over all held-out logs that are simulated, sample by sample: with a clamped trunk, and those of floorLogs().
/// `floor`: of repeats of the final model with noise against itself.
struct HeldOutGap {
  GapErrors before, after, floor;
};

/// `declared`: the model of the case, with the battery's voltage that it gives.
HeldOutGap heldOutGap(const BodyCase& given, const FloorModel& declared, const FloorModel& final_model);
/// Of the sensors in logs with a clamped trunk alone, without a simulation.
HeldOutGap heldOutGapAtRest(const BodyCase& given, const ImuDeviation& final_imu);

}  // namespace darwinop::gap
