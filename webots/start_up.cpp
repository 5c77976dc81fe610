// Start-up of a controller: configuration, connection, session; on failure a message and exit.
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <thread>
#include <utility>

#include "connect/connect.hpp"
#include "webots/messages.hpp"
#include "webots/notices.hpp"
#include "webots/robot_impl.hpp"
#include "webots/stop_signals.hpp"
#include "webots/tool_robot.hpp"

namespace darwinop::webots_api {

namespace {

RobotImpl* current = nullptr;
pid_t owner = 0;  // a child that this process forks must not end its session
std::thread::id owning_thread;
std::terminate_handler usual_end = nullptr;

/// Terminate handler: brings the robot to rest before an uncaught exception ends the program.
void endAfterException() {
  if (std::this_thread::get_id() == owning_thread) release(current);
  if (usual_end) usual_end();
  std::abort();
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

std::optional<Nanos> periodFromEnvironment() {
  const std::string text = environment("DARWINOP_PERIOD_MS");
  if (text.empty()) return std::nullopt;
  int ms = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
  if (error != std::errc{} || end != text.data() + text.size() || ms < 1 || ms > 1000)
    throw std::runtime_error("DARWINOP_PERIOD_MS = " + text + ": give the loop's period in ms, 1 to 1000 (16 or 8)");
  return std::chrono::milliseconds{ms};
}

std::unique_ptr<RobotImpl> start(const ToolSession* tool) {
  const std::string directory = programDirectory();
  // Paths are relative to the program's folder, as on the robot since 2013.
  if (environment("DARWINOP_KEEP_CWD") != "1") std::filesystem::current_path(directory);
  const std::string file = directory + "/config.ini";
  // A tool needs none, but one beside it may limit the robot.
  const bool needs_none = tool != nullptr && !std::filesystem::exists(file);
  const ConfigReading reading = needs_none ? ConfigReading{} : readConfig(file);
  for (const std::string& warning : reading.warnings) logLine(warning);

  connect::ConnectRequest request;
  request.setting = environment("DARWINOP_ROBOT");
  request.period = periodFromEnvironment();
  request.safety = reading.config.safety;
  if (request.period) request.safety.period = *request.period;
  request.config_file = file;
  request.record_path = environment("DARWINOP_RECORD");
  request.record_notes = environment("DARWINOP_RECORD_NOTES");
  request.trunk_is_held = tool != nullptr && tool->trunk_is_held;
  auto robot = std::make_unique<RobotImpl>(connect::connect(request), reading.config, stopRequested());
  robot->is_tool = tool != nullptr;
  const std::string why_not = robot->begin();
  if (!why_not.empty()) throw EndedBeforeReady(why_not);
  return robot;
}

/// Set by setProgramDirectory(); empty: not set.
std::string& otherProgramDirectory() {
  static std::string directory;
  return directory;
}

}  // namespace

RobotImpl* connectOrThrow(const ToolSession* tool) {
  if (current) throw std::runtime_error(messages::kSecondRobot);
  installStopSignals();
  // Line-buffered output also into a pipe (PC, log): it appears immediately and survives a crash.
  if (isatty(STDOUT_FILENO) == 0) (void)std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
  current = start(tool).release();
  owner = getpid();
  owning_thread = std::this_thread::get_id();
  if (std::get_terminate() != endAfterException) usual_end = std::set_terminate(endAfterException);
  // Some controllers call exit() without deleting their Robot: the session must end nevertheless.
  std::atexit([] { release(current); });
  return current;
}

RobotImpl* connectOrExit() {
  try {
    return connectOrThrow();
  } catch (const std::exception& error) {
    logLine(error.what());
    std::exit(EXIT_FAILURE);
  }
}

ToolRobot::ToolRobot(const ToolSession& session) : Robot{connectOrThrow(&session)} {}

void setProgramDirectory(const std::string& directory) {
  otherProgramDirectory() = directory;
}

std::string programDirectory() {
  if (!otherProgramDirectory().empty()) return otherProgramDirectory();
  std::error_code unknown;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  return unknown ? "." : program.parent_path().string();
}

RobotImpl* currentRobot() {
  return current;
}

RobotImpl* adopt(RobotImpl* robot) {
  return current = robot;
}

void release(RobotImpl* robot) {
  if (!robot || robot != current || (owner != 0 && getpid() != owner)) return;
  robot->comeToRest();  // while it is the robot of this process
  current = nullptr;
  delete robot;
}

}  // namespace darwinop::webots_api
