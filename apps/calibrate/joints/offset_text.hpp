// Zero offsets for the user and for robot.ini.
#pragma once

#include <string>
#include <vector>

#include "apps/calibrate/ini_edit.hpp"
#include "apps/calibrate/joints/offset_fit.hpp"
#include "hal/cm730/joint_offsets.hpp"

namespace darwinop::calibrate {

/// `before`: offsets in robot.ini, which the readings were corrected by. Joints that were not found are listed with
/// what to do.
std::string asText(const std::vector<JointOffset>& found, const cm730::JointOffsets& before);

/// Keys of [Offsets] of the joints that were found, with date and evidence as comments.
std::vector<IniValue> iniValues(const std::vector<JointOffset>& found, const cm730::JointOffsets& before,
                                const std::string& date);

}  // namespace darwinop::calibrate
