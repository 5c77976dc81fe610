// What robot.ini says that the rescue has to know.
#pragma once

#include <string>

#include "supervisor/rescue.hpp"

namespace darwinop::supervisor {

/// For this process and those it starts: `home`/robot.ini, when it is there and no other file was named.
void useRobotFileOf(const std::string& home);

/// Throws std::runtime_error when the file is wrong: file, line and what is allowed.
RobotSettings readRobotSettings();

}  // namespace darwinop::supervisor
