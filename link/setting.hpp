// Which robot is meant by DARWINOP_ROBOT or --robot.
#pragma once

#include <string>

namespace darwinop::link {

enum class Kind { kDaemon, kSerial, kVirtual };

struct Setting {
  Kind kind;
  std::string port;  // kSerial: the device
};

/// Reads a setting; an empty one means the daemon if one runs, else the serial port of robot.ini. Throws
/// std::runtime_error, with the choices, for anything that is no robot.
Setting readSetting(const std::string& text);

/// The choices, one line each, for error messages and --help.
std::string settingChoices();

}  // namespace darwinop::link
