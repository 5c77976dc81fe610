#include "connect/connect.hpp"

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "connect/daemon_warnings.hpp"
#include "connect/lockstep_robot.hpp"
#include "connect/messages.hpp"
#include "connect/robot_file.hpp"
#include "connect/robot_file_finding.hpp"
#include "connect/serial_bus.hpp"
#include "connect/setting.hpp"
#include "connect/twin_library.hpp"
#ifdef DARWINOP_WITH_REMOTE_CLIENT
#include "remote/client/tcp_link.hpp"
#endif
#include "runtime/daemon_link.hpp"
#include "runtime/threaded_link.hpp"
#include "safety/layers.hpp"

namespace darwinop::connect {
namespace {

void warn(const ConnectRequest& request, const std::string& lines) {
  if (!request.warn) {
    std::cerr << lines;
    return;
  }
  constexpr std::string_view kSpeaker = "darwinop: ";  // the receiver adds its own program name
  std::istringstream rest{lines};
  for (std::string line; std::getline(rest, line);)
    request.warn(line.starts_with(kSpeaker) ? line.substr(kSpeaker.size()) : line);
}

runtime::LoopConfig loopConfig(const ConnectRequest& request) {
  runtime::LoopConfig config;
  config.period = request.period.value_or(kUsualPeriod);
  config.safety = request.safety;
  config.robot = request.robot_name;
  config.record_path = request.record_path;
  config.record_notes = request.record_notes;
  config.trunk_is_held = request.trunk_is_held;
  return config;
}

std::unique_ptr<runtime::RobotLink> serialRobot(const ConnectRequest& request, const std::string& port) {
  const RobotFile robot = readRobotFile();
  runtime::LoopConfig config = loopConfig(request);
  config.period = request.period.value_or(robot.period.value_or(kUsualPeriod));
  config.safety = safetyOn(robot, request.safety, request.config_file);
  config.real_time.demand = runtime::realTimeFromEnvironment();
  OpenedBus opened = openSerialBus({port, config.period, config.safety, robot.offsets, robot.permitted, robot.imu});
  config.safety = opened.safety;
  config.port = opened.description;
  warn(request, robotFileWarning(robot, port) + opened.warnings);
  auto link = std::make_unique<runtime::ThreadedLink>(config, std::move(opened.bus));
  if (!link->warning().empty()) warn(request, "darwinop: " + link->warning() + "\n");
  return link;
}

std::unique_ptr<runtime::RobotLink> daemonsRobot(const ConnectRequest& request) {
  auto link = std::make_unique<runtime::DaemonLink>();
  warn(request, daemonWarnings(request, link->period()));
  if (asksForSafety(request.safety))
    link->setSafety(safety::layered({link->robotSafety(), "the runtime"}, {request.safety, request.config_file}));
  return link;
}

std::unique_ptr<runtime::RobotLink> virtualRobot(const ConnectRequest& request) {
  runtime::LoopConfig config = loopConfig(request);
  config.port = "virtual robot in memory";
  return lockstepRobot(config);
}

std::unique_ptr<runtime::RobotLink> twin(const ConnectRequest& request, const std::string& model) {
  runtime::LoopConfig config = loopConfig(request);
  config.port = twinInHead(model);
  return lockstepRobot(config, makeTwin(model, twinSeed()));
}

#ifdef DARWINOP_WITH_REMOTE_CLIENT
std::unique_ptr<runtime::RobotLink> robotOverTcp(const ConnectRequest& request, const Address& server) {
  // The protocol cannot transmit them, and ignoring a requested limit silently would be unsafe.
  if (asksForSafety(request.safety))
    throw std::runtime_error(request.config_file + messages::kNoSafetyOverTcp +
                             ". Remove them here and put them into robot.ini on the robot, where they hold for every "
                             "controller");
  remote::TcpOptions options;
  options.host = server.host;
  options.port = server.port;
  options.log = [](const std::string& what) { std::cerr << "darwinop: " << what << std::endl; };
  auto link = std::make_unique<remote::TcpLink>(std::move(options));
  warn(request, tcpWarnings(request, link->period()));
  return link;
}
#else
std::unique_ptr<runtime::RobotLink> robotOverTcp(const ConnectRequest&, const Address& server) {
  throw std::runtime_error("tcp://" + server.host +
                           ": programs built for the robot drive the robot that they run on. Build this controller for "
                           "the PC and start it there");
}
#endif

}  // namespace

std::unique_ptr<runtime::RobotLink> connect(const ConnectRequest& request) {
  const Setting setting = readSetting(request.setting);
  switch (setting.kind) {
    case RobotKind::kDaemon:
      return daemonsRobot(request);
    case RobotKind::kSerial:
      return serialRobot(request, setting.port);
    case RobotKind::kVirtual:
      return virtualRobot(request);
    case RobotKind::kTwin:
      return twin(request, setting.model);
    case RobotKind::kTcp:
      return robotOverTcp(request, setting.server);
  }
  throw std::logic_error("a kind of robot that connect() does not know");
}

}  // namespace darwinop::connect
