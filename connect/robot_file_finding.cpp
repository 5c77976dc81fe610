#include "connect/robot_file_finding.hpp"

#include <filesystem>

namespace darwinop::connect {
namespace {

constexpr const char* kCopyIt =
    "on a PC copy the robot's file first: scp darwin@192.168.123.1:/opt/darwinop/robot.ini . ; "
    "export DARWINOP_ROBOT_FILE=$PWD/robot.ini";

/// /dev/ttyUSB0, or a link to it; a pty is in /dev/pts.
bool isRealPort(const std::string& port) {
  std::error_code unknown;
  return std::filesystem::weakly_canonical(port, unknown).string().starts_with("/dev/tty");
}

}  // namespace

cm730::Finding robotFileFinding(const RobotFile& robot, const std::string& port) {
  if (!robot.path.empty() || !isRealPort(port)) return cm730::Finding::ok(describe(robot));
  return cm730::Finding::of(cm730::Kind::kNoRobotFile, describe(robot), kCopyIt);
}

}  // namespace darwinop::connect
