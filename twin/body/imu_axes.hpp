// How the inertial sensors are mounted in the trunk of a model, and its gravity.
#pragma once

#include <array>
#include <cstddef>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// Rows: the sensor's x, y and z in the trunk's frame (left, up, forward).
using MountingMatrix = std::array<std::array<double, 3>, 3>;

/// w x y z.
using MountingQuaternion = std::array<double, 4>;
/// Orientation in the trunk's frame of a sensor at this site of the body, with the mounting of its board.
MountingQuaternion mountedAt(const double* site, const ImuSettings& settings) noexcept;

/// One number of ImuSettings::gyro_axes or accel_axes.
struct ReadAxis {
  std::size_t index;  // of the sensor's true axis
  double sign;
};
ReadAxis readAxis(double axis) noexcept;

struct ImuAxes {
  MountingMatrix gyro{}, accelerometer{};
  double gravity_m_s2 = 0;
};

/// Throws std::runtime_error with the body's file and the reason.
ImuAxes imuAxesOf(const Model& model);

/// Finds the acceleration that the accelerometer of a model reads, without the model's mounting, axes, bias and scale.
class TrunkAcceleration {
 public:
  /// Throws as imuAxesOf does.
  explicit TrunkAcceleration(const Model& model);
  /// In the trunk's frame (left, up, forward), m/s2. Not finite along an axis of scale 0, or that was not read.
  [[nodiscard]] std::array<double, 3> from(const std::array<double, 3>& read_m_s2) const noexcept;

 private:
  MountingMatrix axes_;
  std::array<double, 3> bias_m_s2_, scale_;
};

/// What an accelerometer without the deviations of the model (mounting, axes, bias, scale) reads where that of the
/// model reads this: right, forward, up. Not finite on an axis of scale 0. Throws as imuAxesOf does.
std::array<double, 3> idealReading(const Model& model, const std::array<double, 3>& accel_m_s2);

}  // namespace darwinop::twin
