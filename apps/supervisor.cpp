// darwinop-supervisor: parent of runtime and default controller on a robot, and its operator commands.
#include "supervisor/supervisor.hpp"

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "hal/diagnostics.hpp"
#include "parse_arguments.hpp"
#include "supervisor/ask.hpp"
#include "wrong_argument.hpp"

namespace {

using namespace darwinop;

struct Arguments {
  std::string home;
  bool status = false, stop = false, stop_controller = false, restart_controller = false;
};

/// Beside this program.
std::string runtimeProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / "darwinop-runtime";
}

int carryOut(const Arguments& given) {
  const runtime::RuntimeFiles files;
  if (given.status) return supervisor::printStatus(files);
  if (given.stop) return supervisor::stopSupervisor(files);
  if (given.stop_controller) return supervisor::stopController(files);
  if (given.restart_controller) return supervisor::restartController(files);
  if (given.home.empty())
    throw app::WrongArgument("--home is missing; specify the installation, for example --home /opt/darwinop");
  const DiagnosticsOutput never_waits;
  return supervisor::Supervisor{{std::filesystem::absolute(given.home), runtimeProgram()}}.run();
}

}  // namespace

int main(int count, char** arguments) try {
  Arguments given;
  CLI::App app{"Starts and monitors runtime and default controller, and brings the robot to rest if the runtime fails.",
               "darwinop supervisor"};
  CLI::Option* what[] = {
      app.add_option("--home", given.home, "run as the supervisor of this installation (robot.ini, default, log/)"),
      app.add_flag("--status", given.status, "print its state; exit code 1 if none runs"),
      app.add_flag("--stop-controller", given.stop_controller,
                   "end the default controller and wait for it; the robot sits down"),
      app.add_flag("--restart-controller", given.restart_controller,
                   "restart the default controller, also after repeated crashes or a runtime failure"),
      app.add_flag("--stop", given.stop, "end everything and wait until the robot is at rest")};
  for (CLI::Option* one : what)
    for (CLI::Option* other : what)
      if (one != other) one->excludes(other);
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.footer("Example, without a robot: see docs/supervisor.md");
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  return carryOut(given);
} catch (const std::exception& error) {
  std::cerr << "darwinop supervisor: " << error.what() << '\n';
  return app::exitCodeOf(error);
}
