// Settings in robot.ini that the rescue needs.
#pragma once

#include <string>

#include "supervisor/rescue.hpp"

namespace darwinop::supervisor {

/// For this process and its children: uses `home`/robot.ini if it exists and no other file was specified.
void useRobotFileOf(const std::string& home);

/// Throws std::runtime_error with file, line and expected value if the file is invalid.
RobotSettings readRobotSettings();

/// Called when the runtime has just opened the port, which need not have existed before; a port that has gone again
/// changes nothing.
void noteIdentity(RobotSettings& robot, const std::string& sys_tty = cm730::kSysTty);

}  // namespace darwinop::supervisor
