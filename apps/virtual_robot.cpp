// darwinop-virtual-robot: a virtual CM-730 with twenty MX-28 on a pseudo terminal.
#include <signal.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "connect/setting.hpp"
#include "connect/twin_library.hpp"
#include "hal/signals.hpp"
#include "hal/text_file.hpp"
#include "hil-mocks/fault_script.hpp"
#include "hil-mocks/link_owner.hpp"
#include "hil-mocks/pty_host.hpp"
#include "hil-mocks/robot_options.hpp"
#include "hil-mocks/torque_on_counter.hpp"
#include "parse_arguments.hpp"
#include "virtual_robot_report.hpp"
#include "wrong_argument.hpp"
#ifdef DARWINOP_VIRTUAL_CAMERA  // on a PC
#include "virtual_robot_camera.hpp"
#endif

namespace {

using darwinop::Nanos;
namespace hil = darwinop::hil;

using darwinop::app::printJoints;
using darwinop::app::report;
using darwinop::app::warnOfLag;

constexpr Nanos kPhysicsRest = std::chrono::milliseconds{2};  // bounds the simulation time before a reply

struct Arguments {
  std::string link, faults, body = "plain", camera;
  std::vector<std::string> servo, board;
  bool fast = false;
  std::uint64_t seed = 1;
  double for_s = 0, latency_ms = 0;
};

void describe(CLI::App& app, Arguments& a) {
  app.add_option("--link", a.link, "Path of a symbolic link to the port");
  app.add_option("--body", a.body, "Mechanics: plain, twin, or twin:MODEL")->capture_default_str();
#ifdef DARWINOP_VIRTUAL_CAMERA
  app.add_option("--camera", a.camera,
                 "Frame file for the camera picture; the environment for client programs is printed");
#endif
  app.add_flag("--fast", a.fast, "Reply at once instead of at 1 Mbaud");
  app.add_option("--faults", a.faults, "Fault script; format: docs/virtual-robot.md")->check(CLI::ExistingFile);
  app.add_option("--servo", a.servo, "Servo configuration, JOINT=SETTING: " + hil::servoSettings());
  app.add_option(
      "--board", a.board,
      "Board: cm-730, cm-740, none or model:NUMBER; missing feature: no-bulk-read, no-sync-write, one-block-length");
  app.add_option("--seed", a.seed, "Random seed")->capture_default_str();
  app.add_option("--for", a.for_s, "Duration in seconds")->check(CLI::Range(0.01, 1e6));
  app.add_option("--latency-timer", a.latency_ms, "FTDI latency timer in ms (driver default: 16)")
      ->check(CLI::Range(0, 255));
  app.footer(
      "Example:\n  darwinop-virtual-robot --link /tmp/darwin &\n  darwinop run --robot /tmp/darwin "
      "build/release/controllers/01_hello_head\n");
}

hil::BoardOptions boardOptions(const Arguments& a) {
  hil::BoardOptions options;
  if (a.fast) options.byte_time = Nanos{0};
  for (const std::string& setting : a.servo) hil::setServo(options, setting);
  for (const std::string& lack : a.board) hil::setBoard(options, lack);
  return options;
}

/// `start`: the robot's time when its port opens, 0 of the script.
std::vector<hil::InjectedFault> faultsIn(const std::string& path, Nanos start) {
  const std::optional<std::string> text = darwinop::readTextFile(path, hil::kLongestFaultScript);
  if (!text) throw std::runtime_error("cannot read fault script " + path + " of --faults");
  std::vector<hil::InjectedFault> faults = hil::parseFaultScript(*text, path);
  for (hil::InjectedFault& fault : faults) fault.at += start;
  return faults;
}

std::unique_ptr<darwinop::Body> makeBody(const Arguments& a) {
  if (a.body == "plain") return nullptr;
  if (const std::optional<std::string> model = darwinop::connect::twinModel(a.body))
    return darwinop::connect::makeTwin(*model, a.seed);
  throw std::runtime_error("--body " + a.body + ": expected plain, twin, or twin:MODEL");
}

/// Waits for a signal of kEndSignals or the end of the time. The signals are blocked in every thread.
void waitForEnd(const sigset_t& signals, double for_s, bool physics, hil::PtyHost& host) {
  const double end_s = std::chrono::duration<double>(host.now()).count() + (for_s > 0 ? for_s : 1e9);
  bool warned = false;
  for (;;) {
    warned = warned || warnOfLag(host, physics);
    const double left_s = std::max(end_s - std::chrono::duration<double>(host.now()).count(), 0.0);
    const double wait_s = std::min(left_s, 1.0);
    const auto seconds = static_cast<time_t>(wait_s);
    const timespec time{seconds, static_cast<long>((wait_s - static_cast<double>(seconds)) * 1e9)};
    const int signal = sigtimedwait(&signals, nullptr, &time);
    if (signal == SIGUSR1) printJoints(host);
    if (std::ranges::find(darwinop::kEndSignals, signal) != darwinop::kEndSignals.end() ||
        (signal < 0 && left_s <= wait_s))
      return;
  }
}

int serve(const Arguments& a) {
  if (const std::string owner = a.link.empty() ? std::string{} : hil::linkOwner(a.link); !owner.empty())
    throw std::runtime_error(a.link + hil::kLinkTaken + owner + "; end it or choose another --link");
  sigset_t signals = darwinop::blockEndSignals();
  sigaddset(&signals, SIGUSR1);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // before the first thread: only waitForEnd() receives them

  hil::BoardOptions options = darwinop::app::fromArguments([&] { return boardOptions(a); });
  hil::PtyOptions pty;
  pty.link = a.link;
  pty.latency_timer = std::chrono::duration_cast<Nanos>(std::chrono::duration<double, std::milli>(a.latency_ms));
  std::unique_ptr<darwinop::Body> body = darwinop::app::fromArguments([&] { return makeBody(a); });
  const bool physics = body != nullptr;
  if (physics) {
    options.body_step = hil::kPhysicsStep;
    pty.at_rest = kPhysicsRest;
  }
  hil::TorqueOnCounter torque_on;  // outlives the robot
  hil::VirtualRobot robot{options, a.seed, std::move(body)};
  robot.board().observe(&torque_on);
  if (physics) robot.advance(hil::kSettlesIn);
  if (!a.faults.empty())
    robot.faults().add(darwinop::app::fromArguments([&] { return faultsIn(a.faults, robot.now()); }));
  Nanos served{0}, lag{0};
  {
    hil::PtyHost host{robot, pty};
    const Nanos began = host.now();
    std::printf("port: %s\n", host.path().c_str());
    if (!a.link.empty()) std::printf("link: %s\n", a.link.c_str());
#ifdef DARWINOP_VIRTUAL_CAMERA
    const auto camera = darwinop::app::makeCamera(host, a.camera);
#endif
    std::printf("body: %s\n", a.body.c_str());
    if (!a.faults.empty()) std::printf("faults: %s, seed %" PRIu64 "\n", a.faults.c_str(), a.seed);
    std::fflush(stdout);
    waitForEnd(signals, a.for_s, physics, host);
    served = host.now() - began;
    lag = host.worstLag();
  }
  report(robot, torque_on.count(), std::chrono::duration<double>(served).count(), lag);
  return 0;
}

int run(int argc, char** argv) {
  CLI::App app{"A virtual DARwIn-OP: CM-730 board and twenty MX-28 servos on a pseudo terminal, paced at 1 Mbaud.",
               "darwinop virtual-robot"};
  Arguments arguments;
  describe(app, arguments);
  app.set_version_flag("--version", DARWINOP_VERSION);
  if (const auto code = darwinop::app::parseArguments(app, argc, argv)) return *code;
  return serve(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "darwinop virtual-robot: %s\n", error.what());
    return darwinop::app::exitCodeOf(error);
  }
}
