// What start-up and the doctor say of robot.ini.
#pragma once

#include <string>

#include "connect/robot_file.hpp"
#include "hal/cm730/diagnosis/finding.hpp"

namespace darwinop::connect {

/// A robot at a real serial port without its robot.ini is a warning: its limits and offsets would not apply. A pty is a
/// virtual robot, which needs none.
cm730::Finding robotFileFinding(const RobotFile& robot, const std::string& port);
/// The finding as lines of a start's warnings; empty if it is ok.
std::string robotFileWarning(const RobotFile& robot, const std::string& port);

}  // namespace darwinop::connect
