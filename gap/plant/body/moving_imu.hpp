// Readings of the inertial sensor of a moving trunk, from the signals of a trace.
#pragma once

#include <limits>

#include "gap/plant/body/floor_roll_out.hpp"
#include "gap/plant/body/resting_imu.hpp"

namespace darwinop::gap {

/// How a sensor deviates from the model's. The rotation of the board is that of `accel`.
struct ImuDeviation {
  RestingImu::Deviation gyro, accel;
  double lowpass_s = 0;                                          // time constant of the gyroscope, first order
  double range_rad_s = std::numeric_limits<double>::infinity();  // of the gyroscope
  double delay_s = 0;                                            // of both sensors
};

/// The sensors whose readings a trace has: with mounting, axes, filter and delay of the model; its scale, bias and
/// range act on these signals together with a deviation.
twin::ImuSettings tracedSensors(twin::ImuSettings model);

class MovingImu {
 public:
  /// Reads the body's MuJoCo file. Throws std::runtime_error.
  explicit MovingImu(const twin::Model& model);

  struct Readings {
    Eigen::MatrixX3d gyro_rad_s, accel_m_s2;  // rows of the log x axes of the sensor
  };
  [[nodiscard]] Readings of(const FloorTrace& trace, const ImuDeviation& deviation) const;
  /// From the rate of a trace to what this gyroscope reads, without bias, filter and limit.
  [[nodiscard]] Eigen::Matrix3d gyroMatrix(const ImuDeviation& deviation) const;

 private:
  Eigen::Matrix3d gyro_axes_, accel_axes_;  // rows: the sensor's axes in the trunk's frame
  twin::ImuSettings settings_;
  double period_s_;
};

}  // namespace darwinop::gap
