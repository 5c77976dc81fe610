// Factory of robot links: daemon, serial port, virtual robot, twin, TCP.
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
  std::function<void(const std::string&)> warn;  // receives each line of warnings; empty: stderr
};

/// Opens the port, checks the robot, starts the loop, and returns the link. Throws std::runtime_error with error and
/// remedy.
std::unique_ptr<runtime::RobotLink> connect(const ConnectRequest& request);

/// Configuration of a robot on a serial port.
struct SerialRobot {
  std::string port;
  Nanos period{16'000'000};
  safety::Config safety{};
  cm730::JointOffsets offsets{};
};

/// An open bus with its line.
struct OpenedBus {
  std::unique_ptr<ServoBus> bus;
  /// SerialRobot::safety, restricted to the servos' own angle limits and without joints that cannot be driven. A loop
  /// on this bus must use it.
  safety::Config safety{};
  std::string description;  // "/dev/ttyUSB0 (CM-730 firmware 19, 20 servos)"
  std::string warnings;     // findings of the start-up probe, one per line; empty: none
};

/// Range of goals that each servo can receive with these settings, in servo ticks.
cm730::TickRanges goalTicks(const safety::Config& safety, const cm730::JointOffsets& offsets);

/// Opens a serial device and checks the robot on it; hal/cm730/diagnosis/start_policy.hpp defines what is refused.
/// Throws as connect(); cm730::NotReady if retrying is useful.
OpenedBus openSerialBus(const SerialRobot& robot, cm730::Purpose purpose = cm730::Purpose::kDrive);

}  // namespace darwinop::connect
