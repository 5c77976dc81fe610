// Result of a calibration of the inertial sensor: for the user, and for robot.ini.
#pragma once

#include <string>
#include <vector>

#include "apps/calibrate/imu_fit.hpp"
#include "apps/calibrate/ini_edit.hpp"

namespace darwinop::calibrate {

std::string asText(const ImuFit& fit, const cm730::ImuCalibration& before);

/// Keys of [Imu] with date and evidence as comments.
std::vector<IniValue> iniValues(const ImuFit& fit, const std::string& date);

}  // namespace darwinop::calibrate
