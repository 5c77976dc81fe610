// darwinop-runtime: the daemon, and what an operator may ask of it.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>

#include "connect/connect.hpp"
#include "connect/controller_user.hpp"
#include "connect/robot_file.hpp"
#include "connect/wait_for_bus.hpp"
#include "hal/diagnostics.hpp"
#include "hal/signals.hpp"
#include "runtime/daemon.hpp"
#include "runtime/operator.hpp"
#include "webots/config_ini.hpp"

namespace {

using namespace darwinop;

struct Arguments {
  std::string record, real_time = "if-allowed", name, config;
  std::optional<std::string> port, group;  // nothing: what robot.ini says
  std::optional<int> period_ms;
  bool wait = false, status = false, check_pose = false, reset_faults = false, release = false;
};

runtime::LoopConfig loopConfig(const Arguments& given, const connect::RobotFile& robot) {
  runtime::LoopConfig config;
  config.period =
      given.period_ms ? std::chrono::milliseconds{*given.period_ms} : robot.period.value_or(connect::kUsualPeriod);
  config.record_path = given.record;
  config.real_time.demand = runtime::realTimeFromText(given.real_time);
  safety::Config controllers;
  if (!given.config.empty()) {
    if (access(given.config.c_str(), F_OK) != 0)
      throw std::runtime_error("cannot read " + given.config + "; name a file that is there with --config");
    const facade::ConfigReading reading = facade::readConfig(given.config);
    for (const std::string& warning : reading.warnings) std::cerr << warning << '\n';
    controllers = reading.config.safety;
  }
  config.safety = connect::safetyOn(robot, controllers, given.config.empty() ? "config.ini" : given.config);
  return config;
}

std::optional<connect::OpenedBus> openBus(const Arguments& given, const connect::RobotFile& robot,
                                          const runtime::LoopConfig& config) {
  const std::string port = given.port.value_or(robot.serialPort());
  const auto open = [&] { return connect::openSerialBus({port, config.period, config.safety, robot.offsets}); };
  if (!given.wait) return open();
  const auto tell = [](const std::string& what) { std::cerr << "darwinop runtime: " << what << std::endl; };
  return connect::waitForBus(open, endRequested(), tell, connect::pauseFor);
}

int serve(const Arguments& given, const runtime::RuntimeFiles& files) {
  const connect::RobotFile robot = connect::readRobotFile();
  runtime::LoopConfig config = loopConfig(given, robot);
  const gid_t group = connect::runtimeGroup(robot, given.group);
  endOnSignals();
  runtime::FileLock claim = runtime::claimRuntime(files, group);  // first, so that the port is left to who has it
  std::optional<connect::OpenedBus> opened = openBus(given, robot, config);
  if (!opened) return 0;  // asked to end before the robot came
  config.port = opened->description;
  config.safety = opened->safety;
  if (!opened->warnings.empty()) std::cerr << opened->warnings;
  runtime::Daemon daemon{config, files, std::move(claim), group, std::move(opened->bus)};
  if (!daemon.warning().empty()) std::cerr << "darwinop runtime: " << daemon.warning() << '\n';
  std::cout << "ready: pid " << getpid() << " on " << config.port << ", "
            << config.period / std::chrono::milliseconds{1} << " ms, " << files.exchange << std::endl;
  daemon.run(endRequested());
  return 0;
}

/// 0: a controller may begin, 3: not from there.
int checkPose(const runtime::RuntimeFiles& files) {
  const safety::StartPoseCheck check = runtime::startPoseNow(files);
  std::cout << (check.secure() ? "start pose: ok\n" : safety::describe(check));
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
        << "torque is going off and stays off until START is pressed, a controller is started or faults are reset\n";
  } else {
    return serve(given, files);
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  const DiagnosticsOutput never_waits;
  Arguments given;
  CLI::App app{"The loop in a process of its own: controllers come and go (--robot runtime), the robot stays safe.",
               "darwinop runtime"};
  app.add_option("--robot", given.port, "serial device or pty of the robot; else robot.ini's, else /dev/ttyUSB0");
  app.add_flag("--wait", given.wait, "wait for the robot's port and board instead of failing, as at boot");
  app.add_option("--period", given.period_ms,
                 "period in ms: 16, or 8 when only goals are sent; else robot.ini's, else 16")
      ->check(CLI::Range(1, 1000));
  app.add_option("--record", given.record, "write every cycle to this CSV file, see docs/logs.md");
  app.add_option("--config", given.config, "config.ini whose [Safety] and [Limits] hold for every controller");
  app.add_option("--realtime", given.real_time, "required: end when real-time rights are refused; if-allowed: warn")
      ->envname("DARWINOP_REALTIME")
      ->capture_default_str();
  app.add_option("--name", given.name, "name of this runtime, when several run")->envname("DARWINOP_RUNTIME_NAME");
  app.add_option("--group", given.group, "group whose members may drive and look on; else robot.ini's");
  CLI::Option* ask[] = {
      app.add_flag("--status", given.status, "tell state, faults, battery, who drives and how the loop fares"),
      app.add_flag("--check-pose", given.check_pose,
                   "is the robot in its start pose? exit code 3 and what is off when it is not"),
      app.add_flag("--reset-faults", given.reset_faults, "forget latched faults"),
      app.add_flag("--release", given.release, "torque off on every joint, now: hold the robot")};
  app.set_version_flag("--version", DARWINOP_VERSION);
  for (CLI::Option* one : ask)
    for (CLI::Option* other : ask)
      if (one != other) one->excludes(other);
  app.footer(
      "Example, without a robot:\n  darwinop virtual-robot --link /tmp/robot &\n"
      "  darwinop runtime --robot /tmp/robot &\n  darwinop run --robot runtime "
      "build/release/controllers/01_hello_head");
  CLI11_PARSE(app, count, arguments);
  return carryOut(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop runtime: " << error.what() << '\n';
  return 1;
}
