// Keys of [Imu] in robot.ini: one row each.
#pragma once

#include <array>
#include <string_view>

#include "hal/cm730/imu_correction.hpp"

namespace darwinop::connect {

struct ImuKey {
  std::string_view name;
  cm730::ImuCalibration::Axes cm730::ImuCalibration::*axes;
  double low, high;  // of each of its three numbers
  std::string_view unit;
};

inline constexpr std::array kImuKeys{
    ImuKey{"gyro_bias", &cm730::ImuCalibration::gyro_bias_rad_s, -1, 1, "rad/s"},
    ImuKey{"accel_bias", &cm730::ImuCalibration::accel_bias_m_s2, -3, 3, "m/s2"},
    ImuKey{"accel_scale", &cm730::ImuCalibration::accel_scale, 0.8, 1.2, ""},
    ImuKey{"mounting", &cm730::ImuCalibration::mounting_rad, -0.35, 0.35, "rad"},
};

}  // namespace darwinop::connect
