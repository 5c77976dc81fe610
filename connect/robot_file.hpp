// robot.ini: properties of one physical robot, independent of its driver. docs/robot-file.md
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hal/byte_line.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "safety/config.hpp"

namespace darwinop::connect {

inline constexpr const char* kRobotsPort = "/dev/ttyUSB0";  // the CM-730's FTDI bridge on a stock robot
inline constexpr Nanos kUsualPeriod{16'000'000};
inline constexpr double kMostOffset = 0.2;  // rad, 11.5 deg: a horn is put on within half a tooth, 7.2 deg

/// A field that the file does not name is empty.
struct RobotFile {
  std::string path;  // empty: there is no such file
  std::optional<std::string> port, camera;
  std::optional<Nanos> period;
  std::string group, controller_user;  // empty: as connect/controller_user.hpp says
  safety::Config safety{};             // with the joints that the robot lacks
  cm730::JointOffsets offsets{};

  [[nodiscard]] std::string serialPort() const { return port.value_or(kRobotsPort); }
};

/// Throws std::runtime_error that names file, line, key and what is allowed; then nothing of the file holds.
RobotFile parseRobotFile(std::string_view text, const std::string& path);

/// The file that $DARWINOP_ROBOT_FILE names, else `usual` when it exists, else one that says nothing. Throws as
/// parseRobotFile(), and when the named file is not there.
RobotFile readRobotFile(const std::string& usual = "/opt/darwinop/robot.ini");

/// The settings that hold for a controller on this robot: both files' [Safety] and [Limits] (safety/layers.hpp),
/// within what the offsets leave of each joint's range. `controller_file` is for the sentences of std::runtime_error.
safety::Config safetyOn(const RobotFile& robot, const safety::Config& controller, const std::string& controller_file);

/// One line for people: "/opt/darwinop/robot.ini: port /dev/ttyUSB0, 16 ms, offsets: Neck +0.0215".
std::string describe(const RobotFile& robot);

}  // namespace darwinop::connect
