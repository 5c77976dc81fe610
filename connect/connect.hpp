// Factory of robot links: daemon, serial port, virtual robot, twin, TCP.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "runtime/robot_link.hpp"
#include "safety/config.hpp"

namespace darwinop::connect {

/// Configuration of a controller. The defaults are those of a controller on the robot's own computer.
struct ConnectRequest {
  /// As connect/setting.hpp reads it: "runtime", a serial device or pty, "virtual", "twin[:MODEL]",
  /// "tcp://HOST[:PORT]", or empty.
  std::string setting;
  std::optional<Nanos> period;  // at least 8 ms on a real bus; empty: as in robot.ini, else 16 ms
  safety::Config safety{};
  std::string config_file = "config.ini";  // file that `safety` was read from, for error messages
  std::string record_path;                 // CSV of every cycle; empty: none
  std::string record_notes;                // further lines of its head, "key: value"
  std::string robot_name = "darwin-op";
  bool trunk_is_held = false;  // by a stand or a person: a fall is then announced as expected, by an own loop
  std::function<void(const std::string&)> warn;  // receives each line of warnings; empty: stderr
};

/// Opens the port, checks the robot, starts the loop, and returns the link. Throws std::runtime_error with error and
/// remedy.
std::unique_ptr<runtime::RobotLink> connect(const ConnectRequest& request);

}  // namespace darwinop::connect
