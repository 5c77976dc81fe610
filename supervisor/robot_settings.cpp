// Settings in robot.ini that the rescue needs.
#include "supervisor/robot_settings.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "connect/controller_user.hpp"
#include "connect/robot_file.hpp"

namespace darwinop::supervisor {

void useRobotFileOf(const std::string& home) {
  const std::string path = home + "/robot.ini";
  if (access(path.c_str(), F_OK) == 0) setenv("DARWINOP_ROBOT_FILE", path.c_str(), 0);
}

RobotSettings readRobotSettings() {
  const connect::RobotFile file = connect::readRobotFile();
  RobotSettings robot;
  robot.serial = {.port = file.serialPort(),
                  .period = file.period.value_or(connect::kUsualPeriod),
                  .safety = connect::safetyOn(file, safety::Config{}, "config.ini"),
                  .offsets = file.offsets,
                  .permitted = file.permitted,
                  .imu = file.imu};
  try {
    robot.group = connect::runtimeGroup(file);
  } catch (const std::runtime_error&) {  // the runtime reports and rejects a missing group
  }
  noteIdentity(robot);
  return robot;
}

void noteIdentity(RobotSettings& robot, const std::string& sys_tty) {
  if (auto found = cm730::usbIdentity(robot.serial.port, sys_tty)) robot.identity = std::move(found);
}

}  // namespace darwinop::supervisor
