#include "window/robot_choice.hpp"

#include <stdexcept>
#include <utility>

#include "connect/setting.hpp"
#include "hal/net/resolve.hpp"
#include "remote/client/tcp_link.hpp"
#include "runtime/daemon_link.hpp"
#include "window/eyes.hpp"

namespace darwinop::window {
namespace {

constexpr Nanos kServerPatience{3'000'000'000};
constexpr std::uint16_t kMonitorPort = 5024;

/// "tcp://…": the robot is on another computer.
bool isElsewhere(const RobotChoice& choice) {
  return choice.robot.starts_with("tcp://") || !choice.monitor.empty();
}

/// Where the robot's monitor is: beside its server unless --monitor says otherwise.
connect::Address monitorOf(const RobotChoice& choice) {
  connect::Address monitor;
  monitor.port = kMonitorPort;
  if (choice.monitor.empty()) {
    monitor.host = connect::readSetting(choice.robot).server.host;
  } else {
    monitor = connect::readSetting("tcp://" + choice.monitor).server;
    if (choice.monitor.find(':') == std::string::npos) monitor.port = kMonitorPort;
  }
  return monitor;
}

}  // namespace

std::unique_ptr<OwnRobot> ownRobot(const RobotChoice& choice, const std::vector<std::string>& controller) {
  const std::string& robot = choice.robot;
  if (robot == "runtime" || isElsewhere(choice)) {
    if (!controller.empty())
      throw std::runtime_error(
          "beside a robot that is not the window's own it starts no controller; start it with: darwinop run");
    return nullptr;
  }
  if (robot == "virtual") return std::make_unique<OwnRobot>("plain", controller);
  if (robot == "twin" || robot.starts_with("twin:")) return std::make_unique<OwnRobot>(robot, controller);
  throw std::runtime_error("--robot " + robot + ": it can be twin, twin:MODEL, virtual, runtime or tcp://HOST");
}

Sight sightOf(const RobotChoice& choice, const runtime::RuntimeFiles& files, const std::string& painted,
              const std::shared_ptr<monitor::ColourSearch>& search, const SayLine& say) {
  if (!isElsewhere(choice)) return Sight{monitorWithEyes(files, painted, search, say)};
  const connect::Address at = monitorOf(choice);
  const std::string name = choice.logged_in_to.empty() ? at.host + ":" + std::to_string(at.port) : choice.logged_in_to;
  return Sight{std::make_unique<Bridge>(net::addressesOf(at.host).front(), at.port, name)};
}

std::unique_ptr<runtime::RobotLink> linkToDrive(const RobotChoice& choice, const runtime::RuntimeFiles& files,
                                                const SayLine& say) {
  if (choice.robot.starts_with("tcp://")) {
    const connect::Address at = connect::readSetting(choice.robot).server;
    remote::TcpOptions options;
    options.host = at.host;
    options.port = at.port;
    options.first_patience = kServerPatience;
    options.say = say;
    return std::make_unique<remote::TcpLink>(std::move(options));
  }
  if (isElsewhere(choice))
    throw std::runtime_error("this window only looks on; to drive, start it with --robot tcp://HOST");
  return std::make_unique<runtime::DaemonLink>(files);
}

}  // namespace darwinop::window
