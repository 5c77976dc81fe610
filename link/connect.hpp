// The one place that knows every kind of robot a controller can meet, and builds it.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/servo_bus.hpp"
#include "runtime/robot_link.hpp"
#include "safety/config.hpp"

namespace darwinop::link {

/// What a controller brings along. The defaults are those of a DARwIn-OP on its own computer.
struct Request {
  /// As link/setting.hpp reads it: "runtime", a serial device or pty, "virtual", "twin[:MODEL]",
  /// "tcp://HOST[:PORT]", or empty.
  std::string setting;
  std::optional<Nanos> period;  // 8 ms or more on a real line; nothing: what robot.ini says, else 16 ms
  safety::Config safety{};
  std::string config_file = "config.ini";  // where `safety` was read, for sentences
  std::string record_path;                 // CSV of every cycle; empty: none
  std::string record_notes;                // further lines of its head, "key: value"
  std::string robot_name = "darwin-op";
};

/// Builds the link: opens the port, looks at the robot, starts the loop. Throws std::runtime_error with a
/// sentence that says what is wrong and what to do.
std::unique_ptr<runtime::RobotLink> connect(const Request& request);

/// A bus with its line, for the daemon.
struct OpenedBus {
  std::unique_ptr<ServoBus> bus;
  std::string description;  // "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
  std::string warnings;     // findings of the start-up probe, one a line; empty: none
};

/// Opens a serial device and looks at the robot behind it. Throws as connect() does; cm730::NotReady when port or
/// board may come yet.
OpenedBus openSerialBus(const std::string& port, Nanos period, const cm730::JointOffsets& offsets = {});

}  // namespace darwinop::link
