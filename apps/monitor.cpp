// darwinop-monitor: read-only WebSocket server for sensors, loop, faults and camera.
#include "monitor/monitor.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/colour_search/frame_search.hpp"
#include "connect/camera.hpp"
#include "connect/controller_user.hpp"
#include "end_with_parent.hpp"
#include "hal/net/web/server.hpp"
#include "hal/signals.hpp"
#include "monitor/messages.hpp"
#include "parse_arguments.hpp"
#include "remote/robot/observer_pictures.hpp"
#include "runtime/clock.hpp"
#include "wrong_argument.hpp"

namespace {

using namespace darwinop;

struct MonitorArguments {
  std::string listen = "127.0.0.1", name;
  std::vector<std::string> allow, origins, hosts;
  std::uint16_t port = 5024;
  bool ends_with_parent = false;
  pid_t parent = getppid();
};

void sayMonitor(const std::string& line) {
  std::cerr << "darwinop monitor: " << line << std::endl;
}

/// The shared picture file is reopened for each driver, and read by one thread at a time.
void sayMonitorOnce(const std::string& line) {
  static std::set<std::string> said;
  if (said.insert(line).second) sayMonitor(line);
}

web::WebServerConfig webConfig(const MonitorArguments& given) {
  web::WebServerConfig config;
  config.address = net::ipv4FromText(given.listen);
  config.port = given.port;
  for (const std::string& network : given.allow) config.allowed.push_back(net::networkFromText(network));
  config.origin.origins = given.origins;
  config.origin.hosts = given.hosts;
  if (net::isLoopback(config.address)) return config;
  if (given.allow.empty())
    throw std::runtime_error(
        "--listen " + given.listen +
        " opens the monitor to a network: specify the allowed networks, for example --allow 192.168.123.0/24");
  sayMonitor(
      "the connection has no password: every allowed address can read the robot's sensors and "
      "camera. In a shared network, listen on loopback and connect through ssh");
  return config;
}

int serveObservers(const MonitorArguments& given) {
  const web::WebServerConfig config = app::fromArguments([&] { return webConfig(given); });
  connect::leaveRoot();
  endOnSignals();
  if (given.ends_with_parent && !endWithParent(given.parent)) return 0;
  const runtime::RuntimeFiles files{given.name};
  const auto search = std::make_shared<colour_search::FrameSearch>();
  const remote::FrameCallback find = [search](const CameraFrame& frame) { search->process(frame); };
  monitor::Monitor monitor{files, [] { return runtime::MonotonicClock{}.now(); },
                           [find] {
                             return remote::openPicturesOfCamera(
                                 connect::openLocalCamera({.form = PictureForm::kYuyv, .log = sayMonitor}), find,
                                 sayMonitor);
                           },
                           [files, find] { return remote::openPicturesOfDriver(files, find, sayMonitorOnce); }, search};
  web::WebServer server{config, sayMonitor};
  server.channel("/monitor", monitor::kSubprotocol, monitor);
  std::cout << "ready: ws://" << given.listen << ":" << server.port() << "/monitor" << std::endl;
  while (!endRequested()) {
    server.poll(monitor.pause());
    monitor.update();
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  MonitorArguments given;
  CLI::App app{"Publishes sensors, loop, faults and camera to any number of observers. It never drives.",
               "darwinop monitor"};
  app.add_option("--listen", given.listen, "local address to listen on; 0.0.0.0: all")->capture_default_str();
  app.add_option("--allow", given.allow, "network with access in addition to this computer; repeatable")
      ->allow_extra_args(false);
  app.add_option("--port", given.port, "TCP port; 0: any free port")->capture_default_str();
  app.add_flag("--end-with-parent", given.ends_with_parent, "end together with the parent process, even after kill -9");
  app.add_option("--origin", given.origins, "allowed web origin, for example http://127.0.0.1:8080")
      ->allow_extra_args(false);
  app.add_option("--host", given.hosts, "allowed host name in addition to addresses and localhost")
      ->allow_extra_args(false);
  app.add_option("--name", given.name, "name of the runtime, if there are several")->envname("DARWINOP_RUNTIME_NAME");
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example, beside a running runtime:\n  darwinop monitor\n"
      "On a robot, for its network (docs/monitor.md):\n  darwinop monitor --listen 0.0.0.0 --allow 192.168.123.0/24");
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  return serveObservers(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop monitor: " << error.what() << '\n';
  return app::exitCodeOf(error);
}
