// darwinop-remote: server of the remote-control protocol.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "connect/camera.hpp"
#include "connect/connect.hpp"
#include "connect/controller_user.hpp"
#include "connect/setting.hpp"
#include "end_with_parent.hpp"
#include "hal/diagnostics.hpp"
#include "hal/net/bounded_log.hpp"
#include "hal/signals.hpp"
#include "parse_arguments.hpp"
#include "remote/jpeg/black_image.hpp"
#include "remote/robot/link_port.hpp"
#include "remote/server/messages.hpp"
#include "remote/server/server.hpp"
#include "runtime/clock.hpp"
#include "runtime/daemon_link.hpp"
#include "webots/config_ini.hpp"
#include "wrong_argument.hpp"

namespace {

using namespace darwinop;

struct RemoteArguments {
  std::string robot = "runtime", listen = "127.0.0.1", config;
  std::vector<std::string> allow;
  std::uint16_t port = remote::kUsualPort;
  int width_zoom = 1, height_zoom = 1;
  bool ends_with_parent = false;
  pid_t parent = getppid();
};

/// Rate-limited log for all threads: server, camera and robot link. A client must not be able to fill a robot's disk.
void sayRemote(const std::string& line) {
  static std::mutex mutex;
  static net::BoundedLog log{[](const std::string& text) { std::cerr << "darwinop remote: " << text << std::endl; }};
  const std::lock_guard guard{mutex};
  log.line(line, runtime::MonotonicClock{}.now());
}

remote::ServerConfig serverConfig(const RemoteArguments& given) {
  remote::ServerConfig config;
  config.address = net::ipv4FromText(given.listen);
  config.port = given.port;
  for (const std::string& network : given.allow) config.allowed.push_back(net::networkFromText(network));
  if (net::isLoopback(config.address)) return config;
  if (given.allow.empty())
    throw std::runtime_error(
        "--listen " + given.listen +
        " opens the robot to a network: specify the allowed networks, for example --allow 192.168.123.0/24");
  sayRemote(remote::messages::kNoPassword);
  return config;
}

webots_api::ControllerConfig controllerConfig(const std::string& config) {
  if (config.empty()) return {};
  if (access(config.c_str(), F_OK) != 0)
    throw std::runtime_error("cannot read " + config + "; specify an existing file with --config");
  const webots_api::ConfigReading reading = webots_api::readConfig(config);
  for (const std::string& warning : reading.warnings) sayRemote(warning);
  return reading.config;
}

int serveRemote(const RemoteArguments& given) {
  remote::ServerConfig config = app::fromArguments([&] { return serverConfig(given); });
  connect::ConnectRequest request;
  request.setting = given.robot;
  const webots_api::ControllerConfig controller = app::fromArguments([&] { return controllerConfig(given.config); });
  request.safety = controller.safety;
  if (!given.config.empty()) request.config_file = given.config;
  request.warn = sayRemote;
  const connect::RobotKind kind = app::fromArguments([&] { return connect::readSetting(given.robot).kind; });
  if (kind == connect::RobotKind::kTcp)
    throw app::WrongArgument("--robot " + given.robot + " is already a remote-control server: connect to it directly");
  const bool daemon = kind == connect::RobotKind::kDaemon;
  // In simulated time a client may run as many cycles per second as the machine can; no robot's CPU is affected.
  if (kind == connect::RobotKind::kVirtual || kind == connect::RobotKind::kTwin) config.pace = Nanos{0};
  if (daemon && runtime::daemonPid(runtime::RuntimeFiles{}) == 0)
    sayRemote("no runtime daemon is running; clients are rejected until it is started with: darwinop runtime");
  if (daemon) connect::leaveRoot();
  endOnSignals();
  if (given.ends_with_parent && !endWithParent(given.parent)) return 0;
  remote::LinkPort robot{daemon ? remote::LinkPort::Home::kDaemon : remote::LinkPort::Home::kEmbedded,
                         [&] { return connect::connect(request); }, request.safety.start == safety::StartMove::kHold};
  const auto clock = [] { return runtime::MonotonicClock{}.now(); };
  const remote::ImageSize size{remote::kWholeImage.width / given.width_zoom,
                               remote::kWholeImage.height / given.height_zoom};
  remote::JpegEncoder encoder{size, remote::qualityOf(size)};
  config.no_picture = remote::blackImage(encoder);
  const auto open_frames = [&](runtime::RobotLink& link, PictureForm form) {
    return connect::openCamera(link, {.settings = controller.camera, .form = form, .log = sayRemote});
  };
  const auto open_pictures = [&] { return robot.openPictures(size, open_frames, sayRemote); };
  remote::Server server{config, robot, open_pictures, clock, sayRemote};
  std::cout << "ready: " << given.listen << ":" << server.port() << std::endl;
  server.run(endRequested());
  robot.endAbandonedSession();
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  const DiagnosticsOutput never_waits;
  RemoteArguments given;
  CLI::App app{
      "Remote control over TCP: a simulator on a PC drives this robot. The loop's timing does not depend on the "
      "network.",
      "darwinop remote"};
  const CLI::IsMember zooms{{1, 2, 4, 8}};
  app.add_option("WZ", given.width_zoom, "send the middle 320/WZ columns of each picture: 1, 2, 4 or 8")->check(zooms);
  app.add_option("HZ", given.height_zoom, "send the middle 240/HZ rows")->check(zooms);
  app.add_option("--robot", given.robot, "robot to drive:\n" + connect::settingChoices())
      ->envname("DARWINOP_ROBOT")
      ->capture_default_str();
  app.add_option("--listen", given.listen, "local address to listen on; 0.0.0.0: all")->capture_default_str();
  app.add_option("--allow", given.allow, "network with access in addition to this computer; repeatable")
      ->allow_extra_args(false);
  app.add_option("--port", given.port, "TCP port; 0: any free port")->capture_default_str();
  app.add_flag("--end-with-parent", given.ends_with_parent, "end together with the parent process, even after kill -9");
  app.add_option("--config", given.config,
                 "config.ini with [Safety] and [Limits] for its clients, in addition to the robot's");
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example, without a robot:\n  darwinop remote --robot virtual\n"
      "On a robot, for a simulator on a PC of its network (docs/remote-webots.md):\n"
      "  darwinop remote --listen 0.0.0.0 --allow 192.168.123.0/24");
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  return serveRemote(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop remote: " << error.what() << '\n';
  return app::exitCodeOf(error);
}
