// The one place that knows every kind of robot a controller can meet, and builds it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"
#include "hal/cm730/diagnosis/start_policy.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/servo_bus.hpp"
#include "runtime/robot_link.hpp"
#include "safety/config.hpp"

namespace darwinop::connect {

/// What a controller brings along. The defaults are those of a DARwIn-OP on its own computer.
struct Request {
  /// As connect/setting.hpp reads it: "runtime", a serial device or pty, "virtual", "twin[:MODEL]",
  /// "tcp://HOST[:PORT]", or empty.
  std::string setting;
  std::optional<Nanos> period;  // 8 ms or more on a real line; nothing: what robot.ini says, else 16 ms
  safety::Config safety{};
  std::string config_file = "config.ini";  // where `safety` was read, for sentences
  std::string record_path;                 // CSV of every cycle; empty: none
  std::string record_notes;                // further lines of its head, "key: value"
  std::string robot_name = "darwin-op";
  std::function<void(const std::string&)> warn;  // receives each line of warnings; empty: stderr
};

/// Builds the link: opens the port, looks at the robot, starts the loop. Throws std::runtime_error with a
/// sentence that says what is wrong and what to do.
std::unique_ptr<runtime::RobotLink> connect(const Request& request);

/// What is known of a robot before its port is opened.
struct SerialRobot {
  std::string port;
  Nanos period{16'000'000};
  safety::Config safety{};
  cm730::JointOffsets offsets{};
};

/// A bus with its line, for the daemon.
struct OpenedBus {
  std::unique_ptr<ServoBus> bus;
  /// SerialRobot's, within the limits that the servos have themselves and without the joints that they cannot drive.
  /// A loop on this bus must have these.
  safety::Config safety{};
  std::string description;  // "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
  std::string warnings;     // findings of the start-up probe, one a line; empty: none
};

/// The goals that servos can get with these settings, in their own ticks.
cm730::TickRanges goalTicks(const safety::Config& safety, const cm730::JointOffsets& offsets);

/// Opens a serial device and checks the robot behind it; hal/cm730/diagnosis/start_policy.hpp says what is refused.
/// Throws as connect() does; cm730::NotReady when what is missing may come yet.
OpenedBus openSerialBus(const SerialRobot& robot, cm730::Purpose purpose = cm730::Purpose::kDrive);

}  // namespace darwinop::connect
