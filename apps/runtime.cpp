// darwinop-runtime: the daemon, and what an operator may ask of it.
#include <grp.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <atomic>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include "link/connect.hpp"
#include "runtime/daemon.hpp"
#include "runtime/operator.hpp"
#include "webots/config_ini.hpp"

namespace {

using namespace darwinop;

std::atomic<bool> stop{false};

struct Arguments {
  std::string port = "/dev/ttyUSB0", record, real_time = "if-allowed", name, group, config;
  int period_ms = 16;
  bool status = false, reset_faults = false, release = false;
};

gid_t groupOf(const std::string& name) {
  if (name.empty()) return static_cast<gid_t>(-1);
  if (const group* found = getgrnam(name.c_str())) return found->gr_gid;
  throw std::runtime_error("there is no group '" + name + "'; make it with: sudo groupadd " + name);
}

void stopOnSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { stop = true; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

runtime::LoopConfig loopConfig(const Arguments& given) {
  runtime::LoopConfig config;
  config.period = std::chrono::milliseconds{given.period_ms};
  config.record_path = given.record;
  config.real_time.demand = runtime::realTimeFromText(given.real_time);
  if (given.config.empty()) return config;
  if (!std::ifstream{given.config})
    throw std::runtime_error("cannot read " + given.config + "; name a file that is there with --config");
  const facade::ConfigReading reading = facade::readConfig(given.config);
  for (const std::string& warning : reading.warnings) std::cerr << warning << '\n';
  config.safety = reading.config.safety;
  return config;
}

int serve(const Arguments& given, const runtime::RuntimeFiles& files) {
  runtime::LoopConfig config = loopConfig(given);
  const gid_t group = groupOf(given.group);
  stopOnSignals();
  runtime::FileLock claim = runtime::claimRuntime(files, group);  // first, so that the port is left to who has it
  link::OpenedBus opened = link::openSerialBus(given.port, config.period);
  config.port = opened.description;
  if (!opened.warnings.empty()) std::cerr << opened.warnings;
  runtime::Daemon daemon{config, files, std::move(claim), group, std::move(opened.bus)};
  if (!daemon.warning().empty()) std::cerr << "darwinop runtime: " << daemon.warning() << '\n';
  std::cout << "ready: pid " << getpid() << " on " << config.port << ", " << given.period_ms << " ms, "
            << files.exchange << std::endl;
  daemon.run(stop);
  return 0;
}

int carryOut(const Arguments& given) {
  const runtime::RuntimeFiles files{given.name};
  if (given.status) {
    std::cout << runtime::daemonStatus(files);
  } else if (given.reset_faults) {
    runtime::resetFaults(files);
    std::cout << "faults reset\n";
  } else if (given.release) {
    runtime::releaseRobot(files);
    std::cout << "torque is going off; a controller that is started takes over again\n";
  } else {
    return serve(given, files);
  }
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  Arguments given;
  CLI::App app{"The loop in a process of its own: controllers come and go (--robot runtime), the robot stays safe.",
               "darwinop runtime"};
  app.add_option("--robot", given.port, "serial device or pty of the robot")->capture_default_str();
  app.add_option("--period", given.period_ms, "period in ms: 16, or 8 when only goals are sent")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--record", given.record, "write every cycle to this CSV file, see docs/logs.md");
  app.add_option("--config", given.config, "config.ini whose [Safety] and [Limits] hold for every controller");
  app.add_option("--realtime", given.real_time, "required: end when real-time rights are refused; if-allowed: warn")
      ->envname("DARWINOP_REALTIME")
      ->capture_default_str();
  app.add_option("--name", given.name, "name of this runtime, when several run")->envname("DARWINOP_RUNTIME_NAME");
  app.add_option("--group", given.group, "group whose members may drive and look on");
  CLI::Option* ask[] = {
      app.add_flag("--status", given.status, "tell state, faults, battery, who drives and how the loop fares"),
      app.add_flag("--reset-faults", given.reset_faults, "forget latched faults"),
      app.add_flag("--release", given.release, "torque off on every joint, now: hold the robot")};
  app.set_version_flag("--version", DARWINOP_VERSION);
  ask[0]->excludes(ask[1])->excludes(ask[2]);
  ask[1]->excludes(ask[2]);
  app.footer(
      "Example, without a robot:\n  darwinop virtual-robot --link /tmp/robot &\n"
      "  darwinop runtime --robot /tmp/robot &\n  darwinop run --robot runtime "
      "build/release/controllers/01_hello_head");
  CLI11_PARSE(app, count, arguments);
  try {
    return carryOut(given);
  } catch (const std::exception& error) {
    std::cerr << "darwinop runtime: " << error.what() << '\n';
    return 1;
  }
}
