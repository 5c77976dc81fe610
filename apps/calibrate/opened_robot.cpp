#include "apps/calibrate/opened_robot.hpp"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <stdexcept>
#include <utility>

#include "apps/calibrate/messages.hpp"
#include "connect/connect.hpp"
#include "connect/lockstep_robot.hpp"
#include "connect/messages.hpp"
#include "connect/setting.hpp"
#include "connect/twin_library.hpp"
#include "hal/cm730/port_messages.hpp"
#include "hal/replace_file.hpp"
#include "hal/text_file.hpp"
#include "runtime/daemon_link.hpp"
#include "safety/config.hpp"

namespace darwinop::calibrate {
namespace {

/// The trunk is held: no move to the start pose, no kneeling at the end, and a lying robot has not fallen.
safety::Config heldRobot() {
  safety::Config config;
  config.set("Safety", "start", "hold");
  config.set("Safety", "on_exit", "limp");
  config.set("Safety", "on_fall", "report");
  config.set("Safety", "fall_tilt", "170");
  return config;
}

connect::RobotFile fileNamed(const std::string& path) {
  const auto text = path.empty() ? std::nullopt : readTextFile(path);
  return text ? connect::parseRobotFile(*text, path) : connect::RobotFile{};
}

std::string runsHere(const std::string& pid) {
  return messages::kRuntimeRunsHere + pid + "): " + cm730::howToStopRuntime(pid) +
         "; then name the serial port with --robot";
}

OpenedRobot openTwin(const std::string& model, const std::string& file) {
  OpenedRobot out{.link = {}, .stand = {}, .file = fileNamed(file), .is_twin = true};
  runtime::LoopConfig config;
  config.safety = connect::safetyOn(out.file, heldRobot(), "darwinop calibrate");
  config.port = "twin in memory";
  config.trunk_is_held = true;
  std::unique_ptr<Body> body = connect::makeTwin(model, connect::twinSeed());
  out.stand = std::make_unique<TwinClamp>(*body);
  out.link = connect::lockstepRobot(config, std::move(body), {out.file.offsets, out.file.imu});
  return out;
}

}  // namespace

void requireReplaceable(const std::string& file) {
  try {
    unlink(writeBeside(linkedFile(file), "").c_str());
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string{error.what()} + "; use sudo, another --file, or --dry-run");
  }
}

OpenedRobot openRobot(const std::string& setting, const std::string& file, bool unattended) {
  // A file that does not exist yet: programs read the defaults, not another robot's file.
  if (!file.empty()) setenv("DARWINOP_ROBOT_FILE", readTextFile(file) ? file.c_str() : "/dev/null", 1);
  const connect::Setting robot = connect::readSetting(setting);
  if (setting.empty() && robot.kind == connect::RobotKind::kDaemon)
    throw std::runtime_error(runsHere(std::to_string(runtime::daemonPid(runtime::RuntimeFiles{}))));
  if (connect::loopIsElsewhere(robot)) throw std::runtime_error("--robot " + setting + messages::kOtherLoop);
  if (robot.kind == connect::RobotKind::kTwin) return openTwin(robot.model, file);
  if (robot.kind == connect::RobotKind::kVirtual) throw std::runtime_error(messages::kNothingToCalibrate);
  if (unattended) throw std::runtime_error(messages::kNeedsHands);
  if (!file.empty() && !readTextFile(file))
    throw std::runtime_error(file + messages::kNoSuchRobotFile + connect::messages::kCopyRobotFile + file +
                             " (a new robot has none: touch " + file + ")");
  connect::ConnectRequest request;
  request.setting = setting;
  request.safety = heldRobot();
  request.config_file = "darwinop calibrate";
  request.trunk_is_held = true;
  OpenedRobot out;
  if (robot.kind == connect::RobotKind::kSerial) out.file = connect::readRobotFile();
  out.stand = std::make_unique<OwnersHands>(std::cin, std::cout);
  out.link = connect::connect(request);
  return out;
}

std::string fileToWrite(const OpenedRobot& robot, const std::string& file) {
  if (!file.empty() || robot.is_twin) return file;
  return connect::robotFilePath();
}

}  // namespace darwinop::calibrate
