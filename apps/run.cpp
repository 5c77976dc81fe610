// darwinop-run: runs a controller on a robot and reports loop statistics.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "connect/controller_user.hpp"
#include "hal/body_library.hpp"
#include "hal/net/ssh/session.hpp"
#include "hal/net/ssh/target.hpp"
#include "parse_arguments.hpp"
#include "runtime/controller_run.hpp"
#include "runtime/recording_file.hpp"
#include "ssh_login.hpp"

namespace {

constexpr const char* kRobotHelp =
    "robot: runtime (the daemon), a serial device or pty (/dev/ttyUSB0), virtual (in the controller's process, "
    "simulated time), twin or twin:MODEL (the same with physics), tcp://USER@HOST (starts remote control on that robot "
    "through ssh, see docs/remote.md). Default: DARWINOP_ROBOT, or else the first one found";

/// CLI11 omits the arguments of allow_extras() from the usage line.
class Usage : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App*, std::string name) const override {
    return "Usage: " + name + " [OPTIONS] CONTROLLER [arguments of the controller]\n";
  }
};

/// A controller changes to its own folder, so relative names must be resolved first.
std::string absolute(const std::string& path) {
  return path.empty() ? path : std::filesystem::absolute(path).string();
}

/// File names in --robot: a port, or the twin's model.
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

/// Folder "lib" of the tree that this program is in, wherever the controller is.
std::filesystem::path libraries() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path().parent_path() / "lib";
}

void setTwinLibraryPath() {
  std::error_code unknown;
  const std::filesystem::path library = libraries() / darwinop::kTwinLibraryFile;
  if (std::filesystem::exists(library, unknown)) setenv("DARWINOP_TWIN_LIBRARY", library.c_str(), 0);
}

/// Options for tcp://USER@HOST only.
struct SshOptions {
  darwinop::SshLogin login;
  std::string picture;
  bool force = false;

  [[nodiscard]] bool any() const { return login.any() || !picture.empty() || force; }
};

void addSshOptions(CLI::App& app, SshOptions& ssh) {
  app.add_option("--picture", ssh.picture, "picture size, for example 160x120: the middle of 320x240");
  app.add_flag("--force", ssh.force, "start in any pose of the robot: hold it");
  for (const char* name : {"--picture", "--force"}) app.get_option(name)->group(darwinop::kWithSsh);
  addSshLogin(app, ssh.login);
}

/// Runs the controller on this PC with the remote robot.
int runOverSsh(const std::string& target, const SshOptions& ssh, darwinop::runtime::RunRequest& request) {
  (void)darwinop::runtime::controllerProgram(
      request.command.at(0));  // first: an invalid path is reported before ssh asks for a password
  std::vector<std::string> words = sshWords(ssh.login);
  words.insert(words.end(), {"--tell", std::to_string(getpid())});
  if (!ssh.picture.empty()) words.insert(words.end(), {"--picture", ssh.picture});
  if (ssh.force) words.emplace_back("--force");
  words.push_back(target);
  darwinop::ssh::SshSession robot{"darwinop run", words};
  const std::vector<std::uint16_t> ports = robot.waitUntilReady();
  if (ports.empty()) return std::max(robot.end(), 1);
  request.robot = "tcp://127.0.0.1:" + std::to_string(ports.front());
  const int status = darwinop::runtime::runController(request);
  const int ssh_status = robot.end();
  return status != 0 ? status : ssh_status;
}

}  // namespace

int main(int count, char** arguments) try {
  darwinop::runtime::RunRequest request;
  int period_ms = 0;
  CLI::App app{
      "Runs a controller on a robot and reports loop statistics. The last line starts with \"report:\" and is "
      "machine-readable.\n\n"
      "CONTROLLER is the built program, a Python script NAME.py, or its folder. Arguments after -- are passed to the "
      "controller.",
      "darwinop run"};
  app.formatter(std::make_shared<Usage>());
  app.set_version_flag("--version", DARWINOP_VERSION);
  app.add_option("--robot", request.robot, kRobotHelp);
  app.add_option("--record", request.record, "write every cycle to this CSV file, see docs/logs.md");
  app.add_option("--period", period_ms, "period of the loop in ms: 16, or 8 if only goals are sent")
      ->check(CLI::Range(1, 1000));
  SshOptions ssh;
  addSshOptions(app, ssh);
  app.footer("Example, without a robot:\n  darwinop run --robot virtual build/release/controllers/01_hello_head");
  app.allow_extras();  // other arguments are passed to the controller in this order
  if (const auto code = darwinop::app::parseArguments(app, count, arguments)) return *code;
  request.command = app.remaining();
  if (!request.command.empty() && request.command.front() != "--" && request.command.front().starts_with('-')) {
    std::cerr << "darwinop run: unknown option " << request.command.front() << "; see darwinop run --help\n";
    return darwinop::app::kWrong;
  }
  const auto all_theirs = std::find(request.command.begin(), request.command.end(), "--");
  if (all_theirs != request.command.end()) request.command.erase(all_theirs);
  if (request.command.empty()) {
    std::cerr << "darwinop run: CONTROLLER is missing\n\n" << app.help();
    return 2;
  }

  setTwinLibraryPath();
  request.robot = withAbsolutePath(request.robot);
  darwinop::runtime::requireNewRecording(request.record);
  request.record = absolute(request.record);
  request.python_modules = libraries() / "darwinop/python";
  if (period_ms != 0) request.period_ms = std::to_string(period_ms);
  const char* const robot = std::getenv("DARWINOP_ROBOT");
  const auto target = darwinop::ssh::sshTarget(request.robot.empty() && robot != nullptr ? robot : request.robot);
  if (target) return runOverSsh(*target, ssh, request);
  if (ssh.any())
    throw std::runtime_error(
        "--picture, --force, --ssh-port, --ssh-key and --new-host require --robot tcp://USER@HOST; pass options of "
        "the controller after --");
  // A controller does not run as root; it needs the runtime's group only.
  if (darwinop::connect::usesRuntime(request.robot.empty() && robot != nullptr ? robot : request.robot))
    darwinop::connect::leaveRoot();
  return darwinop::runtime::runController(request);
} catch (const std::exception& error) {
  std::cerr << "darwinop run: " << error.what() << '\n';
  return 2;
}
