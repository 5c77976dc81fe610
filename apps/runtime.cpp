// darwinop-runtime: the daemon, and its operator commands.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

#include "connect/controller_user.hpp"
#include "connect/robot_file.hpp"
#include "connect/robot_file_finding.hpp"
#include "connect/serial_bus.hpp"
#include "connect/wait_for_bus.hpp"
#include "hal/diagnostics.hpp"
#include "hal/signals.hpp"
#include "parse_arguments.hpp"
#include "runtime/daemon.hpp"
#include "runtime/messages.hpp"
#include "runtime/operator.hpp"
#include "runtime/robot_notes.hpp"
#include "webots/config_ini.hpp"
#include "wrong_argument.hpp"

namespace {

using namespace darwinop;

struct Arguments {
  std::string record, real_time = "if-allowed", name, config;
  std::optional<std::string> port, group;  // empty: from robot.ini
  std::optional<int> period_ms;
  bool wait = false, status = false, check_pose = false, reset_faults = false, release = false;
};

runtime::LoopConfig loopConfig(const Arguments& given, const connect::RobotFile& robot) {
  runtime::LoopConfig config;
  config.period =
      given.period_ms ? std::chrono::milliseconds{*given.period_ms} : robot.period.value_or(connect::kUsualPeriod);
  config.record_path = given.record;
  config.real_time.demand = app::fromArguments([&] { return runtime::realTimeFromText(given.real_time); });
  safety::Config controllers;
  if (!given.config.empty()) {
    if (access(given.config.c_str(), F_OK) != 0)
      throw app::WrongArgument("cannot read " + given.config + "; specify an existing file with --config");
    const webots_api::ConfigReading reading = app::fromArguments([&] { return webots_api::readConfig(given.config); });
    for (const std::string& warning : reading.warnings) std::cerr << warning << '\n';
    controllers = reading.config.safety;
  }
  config.safety = connect::safetyOn(robot, controllers, given.config.empty() ? "config.ini" : given.config);
  return config;
}

std::optional<connect::OpenedBus> openBus(const Arguments& given, const connect::RobotFile& robot,
                                          const runtime::LoopConfig& config, const runtime::RuntimeFiles& files) {
  const std::string port = given.port.value_or(robot.serialPort());
  const auto open = [&] {
    connect::OpenedBus opened =
        connect::openSerialBus({port, config.period, config.safety, robot.offsets, robot.permitted, robot.imu,
                                [&] { runtime::RobotNotes::noteServoPowerOff(files); }});
    opened.warnings.insert(0, connect::robotFileWarning(robot, port));
    return opened;
  };
  if (!given.wait) return open();
  const auto log = [](const std::string& what) { std::cerr << "darwinop runtime: " << what << std::endl; };
  return connect::waitForBus(open, endRequested(), log, connect::pauseFor);
}

int serve(const Arguments& given, const runtime::RuntimeFiles& files) {
  const connect::RobotFile robot = connect::readRobotFile();
  runtime::LoopConfig config = loopConfig(given, robot);
  const gid_t group = connect::runtimeGroup(robot, given.group);
  endOnSignals();
  runtime::FileLock claim =
      runtime::claimRuntime(files, group);  // first: if another runtime runs, its port must not be opened
  std::optional<connect::OpenedBus> opened = openBus(given, robot, config, files);
  if (!opened) return 0;  // end requested before the robot was found
  config.port = opened->description;
  config.safety = opened->safety;
  if (!opened->warnings.empty()) std::cerr << opened->warnings;
  runtime::Daemon daemon{config, files, std::move(claim), group, std::move(opened->bus)};
  if (!daemon.warning().empty()) std::cerr << "darwinop runtime: " << daemon.warning() << '\n';
  std::cout << "ready: pid " << getpid() << " on " << config.port << ", "
            << config.period / std::chrono::milliseconds{1} << " ms, " << files.exchange << std::endl;
  const runtime::JointSet left = daemon.run(endRequested());
  if (left.none()) return 0;
  std::cerr << "darwinop runtime: " << runtime::messages::kUnderTorque << runtime::namesOf(left) << std::endl;
  return runtime::kExitUnderTorque;
}

/// 0: a controller may start, 3: not from this pose
int checkPose(const runtime::RuntimeFiles& files) {
  const safety::StartPoseCheck check = runtime::startPoseNow(files);
  if (check.secure()) std::cout << "start pose: ok\n";
  if (!check.secure() || check.without_board) std::cout << safety::describe(check);
  return check.secure() ? 0 : 3;
}

int carryOut(const Arguments& given) {
  const runtime::RuntimeFiles files{given.name};
  if (given.status) {
    std::cout << runtime::daemonStatus(files);
  } else if (given.check_pose) {
    return checkPose(files);
  } else if (given.reset_faults) {
    runtime::resetFaults(files);
    std::cout << "faults reset\n";
  } else if (given.release) {
    runtime::releaseRobot(files);
    std::cout
        << "switching torque off; it stays off until START is pressed, a controller is started or faults are reset\n";
  } else {
    return serve(given, files);
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  const DiagnosticsOutput never_waits;
  Arguments given;
  CLI::App app{"Daemon that runs the loop for successive controllers (--robot runtime).", "darwinop runtime"};
  app.add_option("--robot", given.port, "serial device or pty of the robot; default: robot.ini, else /dev/ttyUSB0");
  app.add_flag("--wait", given.wait, "wait for the robot's port and board instead of failing, for boot");
  app.add_option("--period", given.period_ms,
                 "period in ms: 16, or 8 if only goals are sent; default: robot.ini, else 16")
      ->check(CLI::Range(connect::kShortestPeriod.count(), connect::kLongestPeriod.count()));
  app.add_option("--record", given.record, "write every cycle to this CSV file, see docs/logs.md");
  app.add_option("--config", given.config, "config.ini with [Safety] and [Limits] for every controller");
  app.add_option("--realtime", given.real_time, "required: fail without real-time permissions; if-allowed: warn")
      ->envname("DARWINOP_REALTIME")
      ->capture_default_str();
  app.add_option("--name", given.name, "name of this runtime, if there are several")->envname("DARWINOP_RUNTIME_NAME");
  app.add_option("--group", given.group, "group with permission to drive and observe; default: robot.ini");
  CLI::Option* ask[] = {
      app.add_flag("--status", given.status, "print state, faults, battery, driver and loop statistics"),
      app.add_flag("--check-pose", given.check_pose,
                   "check the start pose; exit code 3 and the deviations if it is wrong"),
      app.add_flag("--reset-faults", given.reset_faults, "reset latched faults; fails if the cause of one persists"),
      app.add_flag("--release", given.release, "switch torque off on every joint at once: hold the robot")};
  app.set_version_flag("--version", DARWINOP_VERSION);
  for (CLI::Option* one : ask)
    for (CLI::Option* other : ask)
      if (one != other) one->excludes(other);
  app.footer(
      "Example, without a robot:\n  darwinop virtual-robot --link /tmp/robot &\n"
      "  darwinop runtime --robot /tmp/robot &\n  darwinop run --robot runtime "
      "build/release/controllers/01_hello_head");
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  return carryOut(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop runtime: " << error.what() << '\n';
  return app::exitCodeOf(error);
}
