#include "hal/cm730/imu_correction.hpp"

#include <cmath>

namespace darwinop::cm730 {
namespace {

using Axes = ImuCalibration::Axes;
using Matrix = std::array<Axes, 3>;

/// Rodrigues' formula.
Matrix rotation(const Axes& r) {
  const double angle = std::hypot(r[0], r[1], r[2]);
  // sin(a)/a and (1 - cos(a))/a^2, which are 1 and 1/2 at 0
  const double s = angle < 1e-9 ? 1 : std::sin(angle) / angle;
  const double c = angle < 1e-9 ? 0.5 : (1 - std::cos(angle)) / (angle * angle);
  const Matrix cross{{{0, -r[2], r[1]}, {r[2], 0, -r[0]}, {-r[1], r[0], 0}}};
  Matrix out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      out[i][k] = (i == k ? 1 : 0) + s * cross[i][k] + c * (r[i] * r[k] - (i == k ? angle * angle : 0));
  return out;
}

Axes times(const Matrix& m, const Axes& v) noexcept {
  Axes out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

Axes transposedTimes(const Matrix& m, const Axes& v) noexcept {
  Axes out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[0][i] * v[0] + m[1][i] * v[1] + m[2][i] * v[2];
  return out;
}

// The gyroscope's axes are backward, right, up; the accelerometer's are right, forward, up.
Axes fromGyroAxes(const Axes& g) noexcept {
  return {g[1], -g[0], g[2]};
}
Axes toGyroAxes(const Axes& v) noexcept {
  return {-v[1], v[0], v[2]};
}

}  // namespace

ImuCorrection::ImuCorrection(const ImuCalibration& calibration)
    : calibration_{calibration},
      trunk_from_board_{rotation(calibration.mounting_rad)},
      is_identity_{calibration == ImuCalibration{}} {}

void ImuCorrection::apply(BoardReading& reading) const noexcept {
  if (is_identity_) return;
  const Axes gyro_now = gyro({reading.gyro[0].value, reading.gyro[1].value, reading.gyro[2].value});
  const Axes accel_now =
      accelerometer({reading.accelerometer[0].value, reading.accelerometer[1].value, reading.accelerometer[2].value});
  for (std::size_t i = 0; i < 3; ++i) {
    reading.gyro[i] = RadPerSec{gyro_now[i]};
    reading.accelerometer[i] = MeterPerSec2{accel_now[i]};
  }
}

Axes ImuCorrection::accelerometer(const Axes& raw) const noexcept {
  Axes board{};
  for (std::size_t i = 0; i < 3; ++i)
    board[i] = (raw[i] - calibration_.accel_bias_m_s2[i]) / calibration_.accel_scale[i];
  return times(trunk_from_board_, board);
}

Axes ImuCorrection::gyro(const Axes& raw) const noexcept {
  Axes board{};
  for (std::size_t i = 0; i < 3; ++i) board[i] = raw[i] - calibration_.gyro_bias_rad_s[i];
  return toGyroAxes(times(trunk_from_board_, fromGyroAxes(board)));
}

Axes ImuCorrection::rawAccelerometer(const Axes& corrected) const noexcept {
  Axes raw = transposedTimes(trunk_from_board_, corrected);
  for (std::size_t i = 0; i < 3; ++i) raw[i] = raw[i] * calibration_.accel_scale[i] + calibration_.accel_bias_m_s2[i];
  return raw;
}

Axes ImuCorrection::rawGyro(const Axes& corrected) const noexcept {
  Axes raw = toGyroAxes(transposedTimes(trunk_from_board_, fromGyroAxes(corrected)));
  for (std::size_t i = 0; i < 3; ++i) raw[i] += calibration_.gyro_bias_rad_s[i];
  return raw;
}

}  // namespace darwinop::cm730
