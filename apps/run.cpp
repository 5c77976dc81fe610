// darwinop-run: runs a controller on a robot and reports how the loop fared.
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
#include "runtime/controller_run.hpp"
#include "ssh_login.hpp"

namespace {

constexpr const char* kRobotHelp =
    "which robot: runtime (the daemon), a serial device or pty (/dev/ttyUSB0), virtual (in the controller's process, "
    "simulated time), twin or twin:MODEL (the same with physics), tcp://USER@HOST (a robot elsewhere: remote control "
    "is "
    "started there by ssh and ended afterwards, see docs/remote.md). Unset: DARWINOP_ROBOT, or else what is there";

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

/// What concerns tcp://USER@HOST only.
struct SshOptions {
  darwinop::SshLogin login;
  std::string picture;
  bool force = false;

  [[nodiscard]] bool any() const { return login.any() || !picture.empty() || force; }
};

void addSshOptions(CLI::App& app, SshOptions& ssh) {
  app.add_option("--picture", ssh.picture, "pictures of this size, such as 160x120: the middle of 320x240");
  app.add_flag("--force", ssh.force, "begin whatever the robot's pose is: hold it");
  for (const char* name : {"--picture", "--force"}) app.get_option(name)->group(darwinop::kWithSsh);
  addSshLogin(app, ssh.login);
}

/// Runs the controller on this PC, the robot being the one that ssh leads to.
int runOverSsh(const std::string& target, const SshOptions& ssh, darwinop::runtime::RunRequest& request) {
  (void)darwinop::runtime::controllerProgram(request.command.at(0));  // first: who has a slip there needs no password
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
  SshOptions ssh;
  addSshOptions(app, ssh);
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
  const char* const robot = std::getenv("DARWINOP_ROBOT");
  const auto target = darwinop::ssh::sshTarget(request.robot.empty() && robot != nullptr ? robot : request.robot);
  if (target) return runOverSsh(*target, ssh, request);
  if (ssh.any())
    throw std::runtime_error(
        "--picture, --force, --ssh-port, --ssh-key and --new-host go with --robot tcp://USER@HOST; what is the "
        "controller's comes after --");
  // Not root in a controller: it needs no more than the runtime's group.
  if (darwinop::connect::usesRuntime(request.robot.empty() && robot != nullptr ? robot : request.robot))
    darwinop::connect::leaveRoot();
  return darwinop::runtime::runController(request);
} catch (const std::exception& error) {
  std::cerr << "darwinop run: " << error.what() << '\n';
  return 2;
}
