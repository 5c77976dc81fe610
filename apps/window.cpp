// darwinop-window: web server of the robot window.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/colour_search/frame_search.hpp"
#include "exit_codes.hpp"
#include "hal/net/ssh/target.hpp"
#include "hal/net/web/server.hpp"
#include "hal/signals.hpp"
#include "managers/motion/pages/own_pages.hpp"
#include "monitor/messages.hpp"
#include "parse_arguments.hpp"
#include "runtime/clock.hpp"
#include "ssh_login.hpp"
#include "window/doctor/doctor_channel.hpp"
#include "window/drive/drive_thread.hpp"
#include "window/drive/steering_session.hpp"
#include "window/live/live_channel.hpp"
#include "window/live/live_message.hpp"
#include "window/messages.hpp"
#include "window/page/assets.hpp"
#include "window/page/body_json.hpp"
#include "window/page/pages_json.hpp"
#include "window/page/report_page.hpp"
#include "window/secret.hpp"
#include "window/transfer/transfer.hpp"
#include "window/transfer/transfer_command.hpp"
#include "window/view/robot_choice.hpp"
#include "window/view/ssh_connection.hpp"

namespace {

using namespace darwinop;

constexpr Nanos kDrivingPause{10'000'000};  // more often than a cycle: a session must not seem to stall
constexpr std::size_t kPages = 4;           // at once

struct WindowArguments {
  window::RobotChoice choice;
  std::string model = "darwin-op", name, report;
  std::vector<std::string> controller;
  std::uint16_t port = 0;
  SshLogin login;
};

void logWindow(const std::string& line) {
  std::cerr << "darwinop window: " << line << std::endl;
}

/// A page opens one of each.
struct PageChannel {
  const char* name;
  const char* protocol;
  web::ChannelHandler& handler;
};

/// Everything lies under a path that cannot be guessed: other users of this computer may connect, but find nothing.
std::string serveWindow(web::WebServer& server, const WindowArguments& given, std::span<const PageChannel> channels) {
  const std::string base = "/" + window::newSecret() + "/";
  for (const window::Asset& asset : window::assets())
    server.serve(base + std::string{asset.name}, {std::string{asset.type}, std::string{asset.body}});
  server.serve(base + "body.json", {"application/json", window::bodyJson(given.model)});
  window::serveReport(server, base, given.report);
  server.serve(base + "pages.json", {"application/json", window::pagesJson(motion::ownPages())});
  for (const PageChannel& one : channels) server.channel(base + one.name, one.protocol, one.handler);
  return "http://127.0.0.1:" + std::to_string(server.port()) + base;
}

/// `ssh`: null without a login. Returns after the drive thread has ended.
void showWindow(const WindowArguments& given, window::SimulatedRobot* own, window::SshConnection* ssh) {
  endOnSignals();
  if (ssh != nullptr && window::SshConnection::isEndRequested()) return;
  const runtime::RuntimeFiles files{own ? own->name() : given.name};
  window::MonitorFeed feed = window::openMonitorFeed(given.choice, files, own ? own->cameraFile() : "",
                                                     std::make_shared<colour_search::FrameSearch>(), logWindow);
  window::DriveThread drive_thread{[&] { return window::openDriveLink(given.choice, files, logWindow); },
                                   motion::ownPages()};
  const auto clock = [] { return runtime::MonotonicClock{}.now(); };
  window::SteeringSession session{drive_thread, clock};
  window::Transfer transfer{window::Child::programOf("install"), window::RememberedFile::usual(), clock,
                            window::robotOf(given.choice.logged_in_to, given.login.port, given.login.key)};
  window::DoctorChannel doctor{
      window::doctorCommand(given.choice, window::Child::programOf("doctor"), own ? own->port() : "")};
  window::LiveChannel live{window::cycleSourceOf(given.choice, files), clock, given.model};
  const PageChannel channels[] = {{"monitor", monitor::kSubprotocol, feed.handler()},
                                  {"steering", window::kSteeringProtocol, session},
                                  {"transfer", window::kTransferProtocol, transfer},
                                  {"doctor", window::kDoctorProtocol, doctor},
                                  {"live", window::kLiveProtocol, live}};
  web::WebServerConfig config;
  config.port = given.port;
  config.origin.own_origin = true;
  config.origin.host_remedy = config.origin.origin_remedy = "open the page as 127.0.0.1 or localhost";
  config.max_channels = kPages * std::size(channels);
  web::WebServer server{config, logWindow};
  const std::string address = serveWindow(server, given, channels);
  std::cout << "open in a browser: " << address << '\n';
  if (own) std::cout << own->driveInstructions() << '\n';
  std::cout << "end with Ctrl+C" << std::endl;
  while (!endRequested() && (ssh == nullptr || !ssh->ended())) {
    server.poll(std::min({feed.pause(), transfer.pause(), doctor.pause(), live.pause(),
                          session.drives() ? kDrivingPause : feed.pause()}));
    feed.update();
    session.update();
    transfer.update();
    doctor.update();
    live.update();
    if (const std::string message = own ? own->takeMessage() : ""; !message.empty()) {
      feed.notice(message);
      logWindow(message);
    }
  }
  if (transfer.runs()) logWindow("cancelling the programs on the robot; this takes up to 20 s");
  if (ssh != nullptr && !endRequested()) ssh->notifyPages(server, feed);
}

/// Runs the requested window for any kind of robot. Returns the exit status.
int openWindow(WindowArguments given) {
  const std::optional<std::string> target = ssh::sshTarget(given.choice.robot);
  if (!target && given.login.any())
    throw std::runtime_error("--ssh-port, --ssh-key and --new-host require --robot tcp://USER@HOST");
  if (target && !given.choice.monitor.empty())
    throw std::runtime_error("--monitor cannot be used with --robot tcp://USER@HOST, which starts a monitor there");
  endOnSignals();
  if (window::hasNoRuntimeYet(given.choice, runtime::RuntimeFiles{given.name}))
    logWindow(window::messages::kNoRuntimeYet);
  const std::unique_ptr<window::SimulatedRobot> own = window::startSimulatedRobot(given.choice, given.controller);
  if (!target) {
    showWindow(given, own.get(), nullptr);
    return 0;
  }
  window::SshConnection ssh{*target, sshWords(given.login)};
  if (!ssh.waitUntilReady()) return std::max(ssh.end(), 1);
  given.choice = {.robot = ssh.robot(), .monitor = ssh.monitor(), .logged_in_to = ssh.target()};
  showWindow(given, own.get(), &ssh);
  const int status = ssh.end();
  return endRequested() ? status : std::max(status, 1);
}

}  // namespace

int main(int count, char** arguments) try {
  WindowArguments given;
  CLI::App app{"Shows a robot in a browser: pose, sensor and servo curves, loop, faults.", "darwinop window"};
  app.add_option(
         "--robot", given.choice.robot,
         "twin, twin:MODEL or virtual: start a simulated robot; runtime: the local daemon; tcp://USER@HOST: log in "
         "through ssh; tcp://HOST: connect to its monitor and server")
      ->capture_default_str();
  app.add_option("--monitor", given.choice.monitor, "HOST[:PORT] of a darwinop monitor; --robot tcp://HOST: HOST:5024");
  app.add_option("--report", given.report, "report of darwinop gap to link");
  app.add_option("--model", given.model, "twin model of the 3D view and of the live comparison")->capture_default_str();
  app.add_option("--name", given.name, "name of the runtime, if there are several")->envname("DARWINOP_RUNTIME_NAME");
  app.add_option("--port", given.port, "local TCP port; 0: any free port")->capture_default_str();
  addSshLogin(app, given.login);
  app.add_option("controller", given.controller, "controller to run; its options after --");
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example, without a robot:\n  darwinop window build/release/controllers/05_walk\n"
      "Beside a running runtime:\n  darwinop window --robot runtime\n"
      "A robot elsewhere:\n  darwinop window --robot tcp://darwin@192.168.123.1");
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  return openWindow(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop window: " << error.what() << '\n';
  return darwinop::app::kWrong;
}
