// What robot.ini says that the rescue has to know.
#include "supervisor/robot_settings.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

#include "link/controller_user.hpp"
#include "link/robot_file.hpp"

namespace darwinop::supervisor {

void useRobotFileOf(const std::string& home) {
  const std::string path = home + "/robot.ini";
  if (access(path.c_str(), F_OK) == 0) setenv("DARWINOP_ROBOT_FILE", path.c_str(), 0);
}

RobotSettings readRobotSettings() {
  const link::RobotFile file = link::readRobotFile();
  RobotSettings robot;
  robot.port = file.serialPort();
  robot.period = file.period.value_or(link::kUsualPeriod);
  robot.safety = link::safetyOn(file, safety::Config{}, "config.ini");
  robot.offsets = file.offsets;
  try {
    robot.group = link::runtimeGroup(file);
  } catch (const std::runtime_error&) {  // the runtime refuses a group that does not exist, and says so
  }
  robot.identity = cm730::usbIdentity(robot.port);
  return robot;
}

}  // namespace darwinop::supervisor
