// Gyroscope and accelerometer of the board: ideal signals at their sites in the trunk, with filter, delay, axes, scale,
// bias, noise, range.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstdint>

#include "twin/body/imu_axes.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/body/sensor_lag.hpp"

namespace darwinop::twin {

class Imu {
 public:
  using Axes = std::array<double, 3>;  // x, y, z of the sensor

  Imu(const mjModel& m, const BodyMap& map, const ImuSettings& settings, std::uint64_t seed);

  /// After the trunk was placed: the jump must not appear as an acceleration.
  void reset(const mjModel& m, const mjData& d) noexcept;
  /// After every physics step: the sensors measure the mean over the step.
  void update(const mjModel& m, const mjData& d) noexcept;

  /// Value of the last step in the sensor's axes, clamped to its range. The noise is a function of seed and `sample`
  /// number.
  [[nodiscard]] Axes gyro(const mjData& d, std::uint64_t sample) const noexcept;
  [[nodiscard]] Axes accelerometer(const mjModel& m, const mjData& d, std::uint64_t sample) const noexcept;

 private:
  [[nodiscard]] Axes trueRate(const mjData& d) const noexcept;
  [[nodiscard]] Axes trueAcceleration(const mjModel& m, const mjData& d) const noexcept;
  void siteVelocity(const mjData& d, mjtNum* velocity) const noexcept;

  ImuSettings settings_;
  std::uint64_t seed_;
  int qpos_, dof_;
  mjtNum site_[3];                                      // accelerometer, in the trunk frame
  mjtNum gyro_axes_[4], accel_axes_[4];                 // rotate trunk vectors into sensor axes
  std::array<ReadAxis, 3> gyro_read_{}, accel_read_{};  // true axes that are read as x, y, z
  SensorLag gyro_lag_, accel_lag_;
  mjtNum velocity_[3] = {}, acceleration_[3] = {};  // of the site, in the world frame
};

}  // namespace darwinop::twin
