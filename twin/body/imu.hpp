// The board's gyroscope and accelerometer: what they feel at their places in the trunk, with their faults.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstdint>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {

class Imu {
 public:
  using Axes = std::array<double, 3>;  // x, y, z of the sensor

  Imu(const mjModel& m, const BodyMap& map, const ImuSettings& settings, std::uint64_t seed);

  /// The trunk was put somewhere: what it moved before does not count as acceleration.
  void reset(const mjData& d) noexcept;
  /// After every step: what the sensors feel is the mean of the step.
  void moved(const mjModel& m, const mjData& d) noexcept;

  /// Of the last step, in the sensor's axes, within its range. `sample`: which one it is; the same sample has the
  /// same noise, whoever asks and how often.
  [[nodiscard]] Axes gyro(const mjData& d, std::uint64_t sample) const noexcept;
  [[nodiscard]] Axes accelerometer(const mjModel& m, const mjData& d, std::uint64_t sample) const noexcept;

 private:
  void velocityThere(const mjData& d, mjtNum* velocity) const noexcept;

  ImuSettings settings_;
  std::uint64_t seed_;
  int qpos_, dof_;
  mjtNum place_[3];                                 // of the accelerometer, in the trunk
  mjtNum gyro_axes_[4], accel_axes_[4];             // trunk from sensor
  mjtNum velocity_[3] = {}, acceleration_[3] = {};  // of that place, in the world
};

}  // namespace darwinop::twin
