// Fits bias, scale and mounting of the inertial sensors to their readings in several postures at rest.
#pragma once

#include <array>
#include <vector>

#include "apps/calibrate/posture.hpp"
#include "apps/calibrate/still_reading.hpp"
#include "hal/cm730/imu_correction.hpp"

namespace darwinop::calibrate {

struct PostureReading {
  const TrunkPosture* posture;
  StillReading raw;  // not corrected by robot.ini
};

/// Error of the accelerometer's direction of up in one posture, deg.
struct PostureError {
  const TrunkPosture* posture;
  double before_deg, after_deg;
  double predicted_deg;  // by a fit to the other postures; NaN with fewer than four
};

struct ImuFit {
  cm730::ImuCalibration calibration, sigma;  // sigma: standard deviation of each number
  bool observed = false;                     // false: these postures do not separate all numbers
  std::vector<PostureError> errors;
};

/// `level_deg`: how exactly the trunk was levelled, standard deviation. `before`: the calibration in robot.ini.
ImuFit fitImu(const std::vector<PostureReading>& readings, double level_deg, const cm730::ImuCalibration& before);

/// Angle between the corrected reading and up in this posture.
double tiltErrorDeg(const PostureReading& reading, const cm730::ImuCalibration& calibration);

}  // namespace darwinop::calibrate
