// darwinop-window: the robot in a browser on this PC.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "remote/monitor/messages.hpp"
#include "remote/monitor/monitor.hpp"
#include "remote/robot/link_port.hpp"
#include "remote/web/server.hpp"
#include "runtime/clock.hpp"
#include "runtime/daemon_link.hpp"
#include "window/assets.hpp"
#include "window/body_json.hpp"
#include "window/driver.hpp"
#include "window/own_robot.hpp"
#include "window/secret.hpp"

namespace {

using namespace darwinop;

std::atomic<bool> window_stop{false};

constexpr Nanos kDrivingPause{10'000'000};  // more often than a cycle: a driver must not seem to stall
constexpr bool kStartWhereItIs = true;      // who drags an arm does not want the robot to kneel first

struct WindowArguments {
  std::string robot = "twin", model = "darwin-op", name;
  std::vector<std::string> controller;
  std::uint16_t port = 0;
};

void sayWindow(const std::string& line) {
  std::cerr << "darwinop window: " << line << std::endl;
}

void stopWindowOnSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { window_stop = true; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  signal(SIGPIPE, SIG_IGN);
}

/// Nothing: the robot of a runtime that runs here.
std::unique_ptr<window::OwnRobot> ownRobot(const WindowArguments& given) {
  if (given.robot == "runtime") {
    if (!given.controller.empty())
      throw std::runtime_error(
          "with --robot runtime the window only looks on; start the controller with: darwinop run");
    return nullptr;
  }
  if (given.robot == "virtual") return std::make_unique<window::OwnRobot>("plain", given.controller);
  if (given.robot == "twin" || given.robot.starts_with("twin:"))
    return std::make_unique<window::OwnRobot>(given.robot, given.controller);
  throw std::runtime_error("--robot " + given.robot + ": it can be twin, twin:MODEL, virtual or runtime");
}

/// Everything lies under a path that cannot be guessed: other users of this computer may connect, but find nothing.
std::string serveWindow(web::Server& server, const std::string& model, monitor::Monitor& monitor,
                        window::Driver& driver) {
  const std::string base = "/" + window::newSecret() + "/";
  for (const window::Asset& asset : window::assets())
    server.serve(base + std::string{asset.name}, {std::string{asset.type}, std::string{asset.body}});
  server.serve(base + "body.json", {"application/json", window::bodyJson(model)});
  server.channel(base + "monitor", monitor::kSubprotocol, monitor);
  server.channel(base + "steering", window::kSteeringProtocol, driver);
  return "http://127.0.0.1:" + std::to_string(server.port()) + base;
}

int showWindow(const WindowArguments& given) {
  stopWindowOnSignals();
  const std::unique_ptr<window::OwnRobot> own = ownRobot(given);
  const runtime::RuntimeFiles files{own ? own->name() : given.name};
  monitor::Monitor monitor{files, [] { return runtime::MonotonicClock{}.now(); }, nullptr};
  remote::LinkPort port{remote::LinkPort::Home::kDaemon, [&] { return std::make_unique<runtime::DaemonLink>(files); },
                        kStartWhereItIs};
  window::Driver driver{port, [] { return runtime::MonotonicClock{}.now(); }};
  web::ServerConfig config;
  config.port = given.port;
  config.entry.own_origin = true;
  web::Server server{config, sayWindow};
  const std::string address = serveWindow(server, given.model, monitor, driver);
  std::cout << "open in a browser: " << address << '\n';
  if (own)
    std::cout << "drive it: darwinop run CONTROLLER --robot runtime, with DARWINOP_RUNTIME_NAME=" << own->name()
              << '\n';
  std::cout << "end with Ctrl+C" << std::endl;
  while (!window_stop) {
    server.attend(driver.drives() ? std::min(monitor.pause(), kDrivingPause) : monitor.pause());
    monitor.look();
    driver.turn();
    if (const std::string news = own ? own->news() : ""; !news.empty()) {
      monitor.notice(news);
      sayWindow(news);
    }
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  WindowArguments given;
  CLI::App app{"The robot in a browser: how it stands, curves of its sensors and servos, its loop, its faults.",
               "darwinop window"};
  app.add_option("--robot", given.robot,
                 "twin, twin:MODEL or virtual: a robot of its own; runtime: the one that runs here")
      ->capture_default_str();
  app.add_option("--model", given.model, "model of the twin that gives the picture its shape")->capture_default_str();
  app.add_option("--name", given.name, "name of the runtime, when several run")->envname("DARWINOP_RUNTIME_NAME");
  app.add_option("--port", given.port, "TCP port on this computer; 0: any that is free")->capture_default_str();
  app.add_option("controller", given.controller, "controller that drives the robot; after -- its own options");
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example, without a robot:\n  darwinop window build/release/controllers/05_walk\n"
      "Beside a running runtime:\n  darwinop window --robot runtime");
  CLI11_PARSE(app, count, arguments);
  return showWindow(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop window: " << error.what() << '\n';
  return 1;
}
