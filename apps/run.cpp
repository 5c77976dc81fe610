// darwinop-run: runs a controller on a robot and reports how the loop fared.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "hal/body_library.hpp"
#include "runtime/controller_run.hpp"

namespace {

constexpr const char* kRobotHelp =
    "which robot: runtime (the daemon), a serial device or pty (/dev/ttyUSB0), virtual (in the controller's process, "
    "simulated time), twin or twin:MODEL (the same with physics). Unset: DARWINOP_ROBOT, or else what is there";

/// CLI11 knows nothing of what allow_extras() lets through.
class Usage : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App*, std::string name) const override {
    return "Usage: " + name + " [OPTIONS] CONTROLLER [arguments of the controller]\n";
  }
};

/// A controller changes to its own folder before it looks at names.
std::string absolute(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).string();
}

/// Files in the name of a robot: a port, or the twin's model.
std::string withAbsolutePath(const std::string& robot) {
  constexpr std::string_view kTwin = "twin:";
  if (robot.starts_with(kTwin)) {
    const std::string model = robot.substr(kTwin.size());
    const bool is_file = model.find('/') != std::string::npos || model.ends_with(".ini");
    return is_file ? std::string{kTwin} + absolute(model) : robot;
  }
  const bool is_file = robot.find('/') != std::string::npos && robot.find("://") == std::string::npos;
  return is_file ? absolute(robot) : robot;
}

/// A controller may lie anywhere; the twin's library lies beside this program.
void tellWhereTheTwinIs() {
  namespace fs = std::filesystem;
  std::error_code unknown;
  const fs::path home = fs::read_symlink("/proc/self/exe", unknown).parent_path();
  const fs::path library = home.parent_path() / "lib" / darwinop::kTwinLibraryFile;
  if (fs::exists(library, unknown)) setenv("DARWINOP_TWIN_LIBRARY", library.c_str(), 0);
}

}  // namespace

int main(int count, char** arguments) try {
  darwinop::runtime::RunRequest request;
  int period_ms = 0;
  CLI::App app{
      "Runs a controller on a robot and reports how the loop fared. The last line begins with \"report:\" and is made "
      "for scripts.\n\n"
      "CONTROLLER is the built program, or its folder. After -- everything is the controller's.",
      "darwinop run"};
  app.formatter(std::make_shared<Usage>());
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.add_option("--robot", request.robot, kRobotHelp);
  app.add_option("--record", request.record, "write every cycle to this CSV file, see docs/logs.md");
  app.add_option("--period", period_ms, "period of the loop in ms: 16, or 8 when only goals are sent")
      ->check(CLI::Range(1, 1000));
  app.footer("Example, without a robot:\n  darwinop run --robot virtual build/release/controllers/01_hello_head");
  app.allow_extras();  // what is no option of ours belongs to the controller, in the order given
  CLI11_PARSE(app, count, arguments);
  request.command = app.remaining();
  const auto all_theirs = std::find(request.command.begin(), request.command.end(), "--");
  if (all_theirs != request.command.end()) request.command.erase(all_theirs);
  if (request.command.empty()) {
    std::cerr << "darwinop run: which controller?\n\n" << app.help();
    return 2;
  }

  tellWhereTheTwinIs();
  request.robot = withAbsolutePath(request.robot);
  request.record = absolute(request.record);
  if (period_ms != 0) request.period_ms = std::to_string(period_ms);
  return darwinop::runtime::runController(request);
} catch (const std::exception& error) {
  std::cerr << "darwinop run: " << error.what() << '\n';
  return 2;
}
