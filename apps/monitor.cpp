// darwinop-monitor: lets onlookers see the robot, read only.
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
#include "connect/controller_user.hpp"
#include "connect/eyes.hpp"
#include "end_with_parent.hpp"
#include "hal/net/web/server.hpp"
#include "hal/signals.hpp"
#include "monitor/messages.hpp"
#include "remote/robot/onlooker_eyes.hpp"
#include "runtime/clock.hpp"

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

/// The window of a driver is opened anew with each of them, and looked at by one thread at a time.
void sayMonitorOnce(const std::string& line) {
  static std::set<std::string> said;
  if (said.insert(line).second) sayMonitor(line);
}

web::ServerConfig webConfig(const MonitorArguments& given) {
  web::ServerConfig config;
  config.address = net::ipv4FromText(given.listen);
  config.port = given.port;
  for (const std::string& network : given.allow) config.allowed.push_back(net::networkFromText(network));
  config.entry.origins = given.origins;
  config.entry.hosts = given.hosts;
  if (net::isLoopback(config.address)) return config;
  if (given.allow.empty())
    throw std::runtime_error("--listen " + given.listen +
                             " shows the robot to a network: say who may look, such as --allow 192.168.123.0/24");
  sayMonitor(
      "the channel knows no password: whoever has an address that is allowed here sees what the robot senses, and what "
      "its camera sees. On a network that is not yours alone, listen on loopback and come by ssh");
  return config;
}

int serveOnlookers(const MonitorArguments& given) {
  connect::leaveRoot();
  endOnSignals();
  if (given.ends_with_parent && !endWithParent(given.parent)) return 0;
  const runtime::RuntimeFiles files{given.name};
  const auto search = std::make_shared<colour_search::FrameSearch>();
  const remote::FrameLooker find = [search](const CameraFrame& frame) { search->look(frame); };
  monitor::Monitor monitor{files, [] { return runtime::MonotonicClock{}.now(); },
                           [find] {
                             return remote::openPicturesOfCamera(
                                 connect::openCamera({.form = PictureForm::kYuyv, .say = sayMonitor}), find,
                                 sayMonitor);
                           },
                           [files, find] { return remote::openPicturesOfDriver(files, find, sayMonitorOnce); }, search};
  web::Server server{webConfig(given), sayMonitor};
  server.channel("/monitor", monitor::kSubprotocol, monitor);
  std::cout << "ready: ws://" << given.listen << ":" << server.port() << "/monitor" << std::endl;
  while (!endRequested()) {
    server.attend(monitor.pause());
    monitor.look();
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  MonitorArguments given;
  CLI::App app{"Lets any number of onlookers see the robot: sensors, loop, faults, camera. It never drives.",
               "darwinop monitor"};
  app.add_option("--listen", given.listen, "address of this computer to listen on; 0.0.0.0: all of them")
      ->capture_default_str();
  app.add_option("--allow", given.allow, "network that may look on beside this computer, may be repeated")
      ->allow_extra_args(false);
  app.add_option("--port", given.port, "TCP port; 0: any that is free")->capture_default_str();
  app.add_flag("--end-with-parent", given.ends_with_parent,
               "end when the program that started this one does, even by kill -9");
  app.add_option("--origin", given.origins, "page that may look on, as browsers write it: http://127.0.0.1:8080")
      ->allow_extra_args(false);
  app.add_option("--host", given.hosts, "name by which this computer may be called, beside its numbers and localhost")
      ->allow_extra_args(false);
  app.add_option("--name", given.name, "name of the runtime, when several run")->envname("DARWINOP_RUNTIME_NAME");
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example, beside a running runtime:\n  darwinop monitor\n"
      "On a robot, for its network (docs/monitor.md):\n  darwinop monitor --listen 0.0.0.0 --allow 192.168.123.0/24");
  CLI11_PARSE(app, count, arguments);
  return serveOnlookers(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop monitor: " << error.what() << '\n';
  return 1;
}
