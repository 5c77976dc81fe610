#include "connect/robot_file_finding.hpp"

#include <filesystem>

#include "connect/messages.hpp"

namespace darwinop::connect {
namespace {

/// /dev/ttyUSB0, or a link to it; a pty is in /dev/pts.
bool isRealPort(const std::string& port) {
  std::error_code unknown;
  return std::filesystem::weakly_canonical(port, unknown).string().starts_with("/dev/tty");
}

}  // namespace

cm730::Finding robotFileFinding(const RobotFile& robot, const std::string& port) {
  if (!robot.path.empty() || !isRealPort(port)) return cm730::Finding::ok(describe(robot));
  return cm730::Finding::of(cm730::Kind::kNoRobotFile, describe(robot),
                            std::string{"on a PC copy the robot's file first: "} + messages::kCopyRobotFile +
                                ". ; export DARWINOP_ROBOT_FILE=$PWD/robot.ini");
}

std::string robotFileWarning(const RobotFile& robot, const std::string& port) {
  const cm730::Finding finding = robotFileFinding(robot, port);
  return finding.level == cm730::Level::kOk ? std::string{} : cm730::toText(finding);
}

}  // namespace darwinop::connect
