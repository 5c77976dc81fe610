// Zero offset of a limp joint that the owner holds at zero, by a jig or by eye.
#pragma once

#include <atomic>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "apps/calibrate/ini_edit.hpp"
#include "apps/calibrate/stand.hpp"
#include "core/joints.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::calibrate {

struct HeldJoint {
  Joint joint;
  double reading_rad;  // mean; the error of the offset in robot.ini
  double spread_rad;   // greatest distance of a sample from it
};

/// Asks for each joint in turn. A joint that is under torque, does not answer, or moved is asked for again, three times
/// at most. No command is ever published. Throws std::runtime_error if the robot stops answering.
std::vector<HeldJoint> readHeldJoints(runtime::RobotLink& link, const std::vector<Joint>& joints, std::istream& answers,
                                      const std::atomic<bool>& stop, std::ostream& log);

std::string asText(const std::vector<HeldJoint>& held, const cm730::JointOffsets& before);

/// Keys of [Offsets] with date and evidence as comments; without those beyond the range of the file.
std::vector<IniValue> iniValues(const std::vector<HeldJoint>& held, const cm730::JointOffsets& before,
                                const std::string& date);

}  // namespace darwinop::calibrate
