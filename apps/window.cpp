// darwinop-window: the robot in a browser on this PC.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/colour_search/frame_search.hpp"
#include "hal/net/ssh/target.hpp"
#include "hal/net/web/server.hpp"
#include "hal/signals.hpp"
#include "managers/motion/pages/own_pages.hpp"
#include "monitor/messages.hpp"
#include "runtime/clock.hpp"
#include "ssh_login.hpp"
#include "window/assets.hpp"
#include "window/body_json.hpp"
#include "window/driver.hpp"
#include "window/over_ssh.hpp"
#include "window/pages_json.hpp"
#include "window/report_page.hpp"
#include "window/robot_choice.hpp"
#include "window/secret.hpp"
#include "window/steersman.hpp"
#include "window/transfer.hpp"
#include "window/transfer_command.hpp"

namespace {

using namespace darwinop;

constexpr Nanos kDrivingPause{10'000'000};  // more often than a cycle: a driver must not seem to stall

struct WindowArguments {
  window::RobotChoice choice;
  std::string model = "darwin-op", name, report;
  std::vector<std::string> controller;
  std::uint16_t port = 0;
  SshLogin login;
};

void sayWindow(const std::string& line) {
  std::cerr << "darwinop window: " << line << std::endl;
}

/// Everything lies under a path that cannot be guessed: other users of this computer may connect, but find nothing.
std::string serveWindow(web::Server& server, const WindowArguments& given, window::Sight& sight, window::Driver& driver,
                        window::Transfer& transfer) {
  const std::string base = "/" + window::newSecret() + "/";
  for (const window::Asset& asset : window::assets())
    server.serve(base + std::string{asset.name}, {std::string{asset.type}, std::string{asset.body}});
  server.serve(base + "body.json", {"application/json", window::bodyJson(given.model)});
  window::serveReport(server, base, given.report);
  server.serve(base + "pages.json", {"application/json", window::pagesJson(motion::ownPages())});
  server.channel(base + "monitor", monitor::kSubprotocol, sight.user());
  server.channel(base + "steering", window::kSteeringProtocol, driver);
  server.channel(base + "transfer", window::kTransferProtocol, transfer);
  return "http://127.0.0.1:" + std::to_string(server.port()) + base;
}

/// `ssh`: nothing: nobody has logged in. It returns with the driver's thread at an end.
void showWindow(const WindowArguments& given, window::OwnRobot* own, const window::OverSsh* ssh) {
  endOnSignals();
  if (ssh != nullptr && window::OverSsh::toldToEnd()) return;
  const runtime::RuntimeFiles files{own ? own->name() : given.name};
  window::Sight sight = window::sightOf(given.choice, files, own ? own->eyes() : "",
                                        std::make_shared<colour_search::FrameSearch>(), sayWindow);
  window::Steersman steersman{[&] { return window::linkToDrive(given.choice, files, sayWindow); }, motion::ownPages()};
  const auto clock = [] { return runtime::MonotonicClock{}.now(); };
  window::Driver driver{steersman, clock};
  window::Transfer transfer{window::Child::programOf("install"), window::RememberedFile::usual(), clock,
                            window::robotOf(given.choice.logged_in_to, given.login.port, given.login.key)};
  web::ServerConfig config;
  config.port = given.port;
  config.entry.own_origin = true;
  config.most_channels = 12;  // three for each page
  web::Server server{config, sayWindow};
  const std::string address = serveWindow(server, given, sight, driver, transfer);
  std::cout << "open in a browser: " << address << '\n';
  if (own) std::cout << own->howToDrive() << '\n';
  std::cout << "end with Ctrl+C" << std::endl;
  while (!endRequested() && (ssh == nullptr || !ssh->ended())) {
    server.attend(std::min({sight.pause(), transfer.pause(), driver.drives() ? kDrivingPause : sight.pause()}));
    sight.look();
    driver.turn();
    transfer.turn();
    if (const std::string news = own ? own->news() : ""; !news.empty()) {
      sight.notice(news);
      sayWindow(news);
    }
  }
  if (transfer.runs()) sayWindow("cancelling what runs on the robot; 20 s at most");
  if (ssh != nullptr && !endRequested()) ssh->tellPages(server, sight);
}

/// What the user has asked for, whatever kind of robot it is. Exit status.
int openWindow(WindowArguments given) {
  const std::optional<std::string> target = ssh::sshTarget(given.choice.robot);
  if (!target && given.login.any())
    throw std::runtime_error("--ssh-port, --ssh-key and --new-host go with --robot tcp://USER@HOST");
  if (target && !given.choice.monitor.empty())
    throw std::runtime_error("--monitor does not go with --robot tcp://USER@HOST: a monitor is started there");
  endOnSignals();
  const std::unique_ptr<window::OwnRobot> own = window::ownRobot(given.choice, given.controller);
  if (!target) {
    showWindow(given, own.get(), nullptr);
    return 0;
  }
  window::OverSsh ssh{*target, sshWords(given.login)};
  if (!ssh.arrives()) return std::max(ssh.end(), 1);
  given.choice = {.robot = ssh.robot(), .monitor = ssh.monitor(), .logged_in_to = ssh.target()};
  showWindow(given, own.get(), &ssh);
  const int status = ssh.end();
  return endRequested() ? status : std::max(status, 1);
}

}  // namespace

int main(int count, char** arguments) try {
  WindowArguments given;
  CLI::App app{"The robot in a browser: how it stands, curves of its sensors and servos, its loop, its faults.",
               "darwinop window"};
  app.add_option(
         "--robot", given.choice.robot,
         "twin, twin:MODEL or virtual: a robot of its own; runtime: the one that runs here; tcp://USER@HOST: one that "
         "is logged in to by ssh; tcp://HOST: one whose monitor and server listen there")
      ->capture_default_str();
  app.add_option("--monitor", given.choice.monitor, "HOST[:PORT] of a darwinop monitor; --robot tcp://HOST: HOST:5024");
  app.add_option("--report", given.report, "report of darwinop gap that the page links to");
  app.add_option("--model", given.model, "model of the twin that gives the picture its shape")->capture_default_str();
  app.add_option("--name", given.name, "name of the runtime, when several run")->envname("DARWINOP_RUNTIME_NAME");
  app.add_option("--port", given.port, "TCP port on this computer; 0: any that is free")->capture_default_str();
  addSshLogin(app, given.login);
  app.add_option("controller", given.controller, "controller that drives the robot; after -- its own options");
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer(
      "Example, without a robot:\n  darwinop window build/release/controllers/05_walk\n"
      "Beside a running runtime:\n  darwinop window --robot runtime\n"
      "A robot elsewhere:\n  darwinop window --robot tcp://darwin@192.168.123.1");
  CLI11_PARSE(app, count, arguments);
  return openWindow(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop window: " << error.what() << '\n';
  return 1;
}
