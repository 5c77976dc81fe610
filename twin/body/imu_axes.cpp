#include "twin/body/imu_axes.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>

#include "twin/body/mujoco_model.hpp"

namespace darwinop::twin {
namespace {

/// As it is read: `axes` of the settings.
MountingMatrix mountingOf(const mjModel& m, int site, const ImuSettings& settings, const std::array<double, 3>& axes) {
  const MountingQuaternion mounted = mountedAt(m.site_quat + 4 * site, settings);
  mjtNum columns[9];  // row-major, its columns are the sensor's axes
  mju_quat2Mat(columns, mounted.data());
  MountingMatrix rows{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const ReadAxis read = readAxis(axes[axis]);
    for (std::size_t k = 0; k < 3; ++k) rows[axis][k] = read.sign * columns[3 * k + read.index];
  }
  return rows;
}

}  // namespace

MountingQuaternion mountedAt(const double* site, const ImuSettings& settings) noexcept {
  mjtNum axis[3] = {settings.mounting_rad[0], settings.mounting_rad[1], settings.mounting_rad[2]}, board[4];
  const mjtNum angle = mju_normalize3(axis);
  mju_axisAngle2Quat(board, axis, angle);
  MountingQuaternion out{};
  mju_mulQuat(out.data(), board, site);
  return out;
}

ReadAxis readAxis(double axis) noexcept {
  const long number = std::clamp(std::lround(std::abs(axis)), 1L, 3L);
  return {static_cast<std::size_t>(number - 1), axis < 0 ? -1.0 : 1.0};
}

ImuAxes imuAxesOf(const Model& model) {
  const MjModelPtr body = loadBody(model, /*ball=*/false);
  const BodyMap map = mapBody(*body, model.body.xml);
  return {.gyro = mountingOf(*body, map.gyro, model.imu, model.imu.gyro_axes),
          .accelerometer = mountingOf(*body, map.accelerometer, model.imu, model.imu.accel_axes),
          .gravity_m_s2 = mju_norm3(body->opt.gravity)};
}

TrunkAcceleration::TrunkAcceleration(const Model& model)
    : axes_{imuAxesOf(model).accelerometer}, bias_m_s2_{model.imu.accel_bias_m_s2}, scale_{model.imu.accel_scale} {}

std::array<double, 3> TrunkAcceleration::from(const std::array<double, 3>& read_m_s2) const noexcept {
  std::array<double, 3> trunk{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double read = (read_m_s2[axis] - bias_m_s2_[axis]) / scale_[axis];
    for (std::size_t k = 0; k < 3; ++k) trunk[k] += axes_[axis][k] * read;
  }
  return trunk;
}

std::array<double, 3> idealReading(const Model& model, const std::array<double, 3>& accel_m_s2) {
  const std::array<double, 3> trunk = TrunkAcceleration{model}.from(accel_m_s2);
  return {-trunk[0], trunk[2], trunk[1]};
}

}  // namespace darwinop::twin
