// Removes bias, scale and mounting of the board's inertial sensors from every reading.
#pragma once

#include <array>

#include "hal/servo_bus.hpp"

namespace darwinop::cm730 {

/// Axes of the readings: accelerometer right, forward, up; gyroscope backward, right, up.
struct ImuCalibration {
  using Axes = std::array<double, 3>;
  Axes gyro_bias_rad_s{}, accel_bias_m_s2{};
  Axes accel_scale{1, 1, 1};
  Axes mounting_rad{};  // rotation vector of the board in the trunk: right, forward, up

  bool operator==(const ImuCalibration&) const = default;
};

class ImuCorrection {
 public:
  using Axes = ImuCalibration::Axes;

  ImuCorrection() = default;
  explicit ImuCorrection(const ImuCalibration& calibration);

  /// Readings in the trunk's axes. Without a calibration they stay the same to the last bit.
  void apply(BoardReading& reading) const noexcept;
  [[nodiscard]] Axes accelerometer(const Axes& raw) const noexcept;
  [[nodiscard]] Axes gyro(const Axes& raw) const noexcept;

  /// The inverse: what the register held.
  [[nodiscard]] Axes rawAccelerometer(const Axes& corrected) const noexcept;
  [[nodiscard]] Axes rawGyro(const Axes& corrected) const noexcept;

  [[nodiscard]] const ImuCalibration& calibration() const noexcept { return calibration_; }

 private:
  using Matrix = std::array<Axes, 3>;  // rows
  ImuCalibration calibration_{};
  Matrix trunk_from_board_{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};  // right, forward, up
  bool is_identity_ = true;
};

}  // namespace darwinop::cm730
