// robot.ini: properties of one physical robot, independent of its driver. docs/robot-file.md
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/permitted.hpp"
#include "hal/cm730/imu_correction.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "safety/config.hpp"

namespace darwinop::connect {

inline constexpr const char* kRobotsPort = "/dev/ttyUSB0";  // the CM-730's FTDI bridge on a stock robot
inline constexpr Nanos kUsualPeriod{16'000'000};
inline constexpr double kMostOffset = 0.2;  // rad, 11.5 deg: half a tooth of the horn is 7.2 deg

/// Fields that the file does not set are empty.
struct RobotFile {
  std::string path;  // empty: there is no such file
  std::optional<std::string> port, camera;
  std::optional<Nanos> period;
  std::string group, controller_user;  // empty: see connect/controller_user.hpp
  safety::Config safety{};             // including the joints that the robot lacks
  cm730::JointOffsets offsets{};
  cm730::ImuCalibration imu{};
  cm730::Permitted permitted{};

  [[nodiscard]] std::string serialPort() const { return port.value_or(kRobotsPort); }
};

/// Throws std::runtime_error with file, line, key and allowed values.
RobotFile parseRobotFile(std::string_view text, const std::string& path);

/// File that this process reads: $DARWINOP_ROBOT_FILE, else `usual`.
std::string robotFilePath(const std::string& usual = "/opt/darwinop/robot.ini");

/// Reads the file named by $DARWINOP_ROBOT_FILE, else `usual` if it exists, else returns defaults. Throws as
/// parseRobotFile(), and if the file of the variable does not exist.
RobotFile readRobotFile(const std::string& usual = "/opt/darwinop/robot.ini");

/// Effective settings of a controller on this robot: [Safety] and [Limits] of both files (safety/layers.hpp), with
/// joint ranges reduced by the offsets. `controller_file`: for the messages of std::runtime_error.
safety::Config safetyOn(const RobotFile& robot, const safety::Config& controller, const std::string& controller_file);

/// One line for the user: "/opt/darwinop/robot.ini: port /dev/ttyUSB0, 16 ms, offsets: Neck +0.0215".
std::string describe(const RobotFile& robot);

}  // namespace darwinop::connect
