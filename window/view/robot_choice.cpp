// Selection of the robot by --robot and --monitor.
#include "window/view/robot_choice.hpp"

#include <stdexcept>
#include <utility>

#include "connect/setting.hpp"
#include "hal/net/names/resolve.hpp"
#include "remote/client/tcp_link.hpp"
#include "runtime/controller_run.hpp"
#include "runtime/daemon_link.hpp"
#include "window/live/monitor_source.hpp"
#include "window/live/runtime_source.hpp"
#include "window/view/local_monitor.hpp"

namespace darwinop::window {
namespace {

constexpr Nanos kServerPatience{3'000'000'000};
constexpr std::uint16_t kMonitorPort = 5024;

/// Address of the robot's monitor: the host of its server unless --monitor is given.
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

/// Of the monitor, for messages.
std::string nameOf(const RobotChoice& choice, const connect::Address& at) {
  return choice.logged_in_to.empty() ? at.host + ":" + std::to_string(at.port) : choice.logged_in_to;
}

}  // namespace

bool isRemote(const RobotChoice& choice) {
  return choice.robot.starts_with("tcp://") || !choice.monitor.empty();
}

std::unique_ptr<SimulatedRobot> startSimulatedRobot(const RobotChoice& choice,
                                                    const std::vector<std::string>& controller) {
  const std::string& robot = choice.robot;
  if (robot == "runtime" || isRemote(choice)) {
    if (!controller.empty())
      throw std::runtime_error(
          "the window starts a controller only on its own virtual robot; start it with: darwinop run");
    return nullptr;
  }
  if (!controller.empty()) (void)runtime::controllerProgram(controller.front());  // before anything starts
  if (robot == "virtual") return std::make_unique<SimulatedRobot>("plain", controller);
  if (robot == "twin" || robot.starts_with("twin:")) return std::make_unique<SimulatedRobot>(robot, controller);
  if (robot.starts_with('/'))
    throw std::runtime_error("the window does not open a port: start `darwinop runtime --robot " + robot +
                             "`, then `darwinop window --robot runtime`");
  throw std::runtime_error("unknown --robot " + robot + "; use twin, twin:MODEL, virtual, runtime or tcp://HOST");
}

bool hasNoRuntimeYet(const RobotChoice& choice, const runtime::RuntimeFiles& files) {
  return choice.robot == "runtime" && !isRemote(choice) && runtime::daemonPid(files) == 0;
}

std::function<std::unique_ptr<CycleSource>()> cycleSourceOf(const RobotChoice& choice,
                                                            const runtime::RuntimeFiles& files) {
  if (!isRemote(choice)) return [files] { return std::make_unique<RuntimeSource>(files); };
  const connect::Address at = monitorOf(choice);
  return [address = net::addressesOf(at.host).front(), port = at.port, name = nameOf(choice, at)] {
    return std::make_unique<MonitorSource>(address, port, name);
  };
}

MonitorFeed openMonitorFeed(const RobotChoice& choice, const runtime::RuntimeFiles& files, const std::string& rendered,
                            const std::shared_ptr<monitor::ColourSearch>& search, const LogLine& log) {
  if (!isRemote(choice)) return MonitorFeed{makeLocalMonitor(files, rendered, search, log)};
  const connect::Address at = monitorOf(choice);
  return MonitorFeed{std::make_unique<Bridge>(net::addressesOf(at.host).front(), at.port, nameOf(choice, at))};
}

std::unique_ptr<runtime::RobotLink> openDriveLink(const RobotChoice& choice, const runtime::RuntimeFiles& files,
                                                  const LogLine& log) {
  if (choice.robot.starts_with("tcp://")) {
    const connect::Address at = connect::readSetting(choice.robot).server;
    remote::TcpOptions options;
    options.host = at.host;
    options.port = at.port;
    options.connect_timeout = kServerPatience;
    options.log = log;
    options.start_where_it_is = true;  // as DriveThread asks for
    return std::make_unique<remote::TcpLink>(std::move(options));
  }
  if (isRemote(choice))
    throw std::runtime_error("this window only observes; to drive, start it with --robot tcp://HOST");
  return std::make_unique<runtime::DaemonLink>(files);
}

}  // namespace darwinop::window
