// Gyroscope and accelerometer of the board: ideal signals at their sites in the trunk, with filter, delay, axes, scale,
// bias, noise, range.
#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstdint>
#include <vector>

#include "twin/body/imu_axes.hpp"
#include "twin/body/mujoco_model.hpp"
#include "twin/body/sensor_lag.hpp"

namespace darwinop::twin {

class Imu {
 public:
  using Axes = std::array<double, 3>;  // x, y, z of the sensor

  /// `cycle_s`: over which the accelerometer's value is the mean; at least a physics step. Allocates.
  Imu(const mjModel& m, const BodyMap& map, const ImuSettings& settings, std::uint64_t seed, double cycle_s = 0);

  /// After the trunk was placed: the jump must not appear as an acceleration.
  void reset(const mjModel& m, const mjData& d) noexcept;
  /// After every physics step.
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
  std::vector<std::array<mjtNum, 3>> velocities_;  // of the site, in the world frame; after the steps of a cycle
  std::size_t steps_ = 0;                          // since the reset; the newest velocity is at this, modulo
  mjtNum acceleration_[3] = {};                    // mean over the cycle
};

}  // namespace darwinop::twin
