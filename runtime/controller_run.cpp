// `darwinop run`: starts a controller and reports.
#include "runtime/controller_run.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "runtime/controller_process.hpp"
#include "runtime/daemon_link.hpp"
#include "runtime/exchange.hpp"
#include "runtime/messages.hpp"
#include "runtime/names.hpp"
#include "runtime/observer_connection.hpp"
#include "runtime/operator.hpp"
#include "runtime/python_command.hpp"
#include "runtime/report.hpp"
#include "runtime/torque_left.hpp"

namespace darwinop::runtime {
namespace {

constexpr int kUnmonitored = 1;

/// Statistics of a loop over the run.
class LoopFigures {
 public:
  explicit LoopFigures(Exchange exchange) : exchange_{std::move(exchange)}, session_{exchange_.block().session.load()} {
    exchange_.block().stats.copyTo(*before_);
  }
  /// Counts from the start of the loop.
  void fromTheBeginning() { *before_ = StatsView{}; }

  /// A session has begun since. A daemon can run while the controller drives another robot.
  [[nodiscard]] bool driven() const { return exchange_.block().session.load() != session_; }

  /// Joints of a real robot that may have had torque when the loop's process ended, unless on_exit is to hold. At rest
  /// a servo that is silent since it held its joint.
  [[nodiscard]] JointSet leftTorque(bool ended_well) const {
    const auto now = std::make_unique<StatsView>();
    exchange_.block().stats.copyTo(*now);
    Sensors last;
    const bool timed = !std::isnan(now->wake.max());  // simulated time has no latencies
    if (!timed || !exchange_.block().sensors.read(last)) return {};
    if (ended_well && last.safety.at_end == Reaction::kHold && last.safety.reaction < Reaction::kKneel) return {};
    const JointSet present = everAnswered(last);
    const State state = last.safety.state;
    if (state == State::kLimp || state == State::kOffline) return perhapsUnderTorque(last, present);
    return present.none() ? ~present : present;
  }

  /// Torque that is left now is of servos that are silent: waiting switches nothing off.
  [[nodiscard]] bool isLimp() const {
    Sensors last;
    return exchange_.block().sensors.read(last) && last.safety.state == State::kLimp;
  }

  /// Its process has died without bringing the robot to rest.
  [[nodiscard]] bool daemonDied() const {
    const ExchangeBlock& block = exchange_.block();
    return block.closing.load() == ExchangeBlock::kOpen && daemonPid(RuntimeFiles{}) != block.info.pid;
  }

  void print() const {
    const auto now = std::make_unique<StatsView>();
    exchange_.block().stats.copyTo(*now);
    Sensors last;
    (void)exchange_.block().sensors.read(last);
    const auto run = std::make_unique<StatsView>(now->since(*before_));
    std::cout << '\n' << reportText(*run, last) << reportLine(*run, last) << std::endl;
  }

 private:
  Exchange exchange_;
  std::uint32_t session_;
  std::unique_ptr<StatsView> before_ = std::make_unique<StatsView>();
};

std::optional<LoopFigures> tryAttach(Exchange (*attach)(const RuntimeFiles&), const RuntimeFiles& files) {
  try {
    return LoopFigures{attach(files)};
  } catch (const std::runtime_error&) {
    return std::nullopt;  // no daemon, or the controller created no robot: nothing to report
  }
}

/// `robot`: as requested; empty: as set in the environment.
bool isElsewhere(const std::string& robot) {
  const char* const usual = std::getenv("DARWINOP_ROBOT");
  return (robot.empty() && usual != nullptr ? std::string{usual} : robot).starts_with("tcp://");
}

process::Start startOf(const RunRequest& request, const std::string& program, const std::string& observer) {
  process::Start start{.command = request.command,
                       .environment = {"DARWINOP_EXCHANGE=" + observer},
                       .ends_with_us = true,  // even if we are killed
                       .error_prefix = ""};
  start.command.front() = program;
  if (isPythonScript(program)) {
    start.command.insert(start.command.begin(), findPython(request.python_modules));
    start.environment.push_back(pythonPath(request.python_modules));
  }
  for (const auto& [name, value] : {std::pair{"DARWINOP_ROBOT=", &request.robot},
                                    {"DARWINOP_RECORD=", &request.record},
                                    {"DARWINOP_PERIOD_MS=", &request.period_ms}})
    if (!value->empty()) start.environment.push_back(name + *value);
  return start;
}

std::optional<LoopFigures> tryAttachEmbedded(const std::string& exchange) {
  const auto attach = [](const RuntimeFiles& files) {
    return Exchange::attach(files.exchange, Exchange::Access::kRead);
  };
  return exchange.empty() ? std::nullopt : tryAttach(attach, RuntimeFiles{exchange});
}

/// Of a controller that still runs; true also if that is unknown.
bool keepsTorqueIfKilled(const std::string& exchange) {
  if (!exchange.empty() && !std::filesystem::exists(exchange)) return false;  // it hosts no loop
  const auto embedded = tryAttachEmbedded(exchange);
  return !embedded || (!embedded->isLimp() && embedded->leftTorque(true).any());
}

/// What to name where `folder` does not have the program `missing`.
std::string inPlaceOf(const std::filesystem::path& missing, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const fs::path name = missing.filename();
  // By the controller's own CMake, and by ./dev build from the clone's folder controllers.
  for (const fs::path& place : {folder / "build" / name, folder / "../../build/release/controllers" / name / name})
    if (const fs::path built = place.lexically_normal(); fs::exists(built)) return messages::kBuiltIn + built.string();
  std::vector<std::string> scripts;
  for (const auto& entry : fs::directory_iterator{folder})
    if (isPythonScript(entry.path())) scripts.push_back(entry.path().string());
  if (scripts.empty()) return messages::kBuildFirst;
  std::ranges::sort(scripts);
  std::string list;
  for (const std::string& script : scripts) list += (list.empty() ? "" : ", ") + script;
  return messages::kNameScript + list;
}

}  // namespace

std::string controllerProgram(const std::string& controller) {
  namespace fs = std::filesystem;
  fs::path path{controller};
  if (fs::is_directory(path)) {
    path /= fs::canonical(path).filename();
    const fs::path script = path.string() + kPythonSuffix;
    if (!fs::exists(path) && fs::exists(script)) path = script;
  }
  if (!fs::exists(path))
    throw std::runtime_error(messages::kNoSuchController + path.string() +
                             (fs::is_directory(controller) ? inPlaceOf(path, controller) : ""));
  if (!isPythonScript(path) && access(path.c_str(), X_OK) != 0)
    throw std::runtime_error(path.string() + messages::kNotAProgram + "; name the built controller");
  // A name without a slash is a file in the current folder, not a command in PATH.
  return path.has_parent_path() ? path.string() : "./" + path.string();
}

int runController(const RunRequest& request) {
  const std::string program = controllerProgram(request.command.at(0));
  const ObserverConnection observer;
  const std::optional<LoopFigures> daemon = tryAttach(observeDaemon, RuntimeFiles{});
  const process::Ending ending = runControllerProcess(startOf(request, program, observer.path()), request.hang_up,
                                                      [&] { return keepsTorqueIfKilled(observer.path()); });
  if (ending.by_signal) std::cerr << "the controller was ended by signal " << ending.code << std::endl;

  auto embedded = tryAttachEmbedded(observer.path());
  bool unmonitored = false;  // joints may have torque, and no loop is left
  if (embedded) {
    const JointSet left = embedded->leftTorque(ending.isNormal());
    unmonitored = left.any();
    if (unmonitored)
      std::cerr << messages::kNoLoopLeft << namesOf(left)
                << ". Hold the robot: RESET on its back releases torque; a new `darwinop run` drives it again"
                << std::endl;
    embedded->fromTheBeginning();
    embedded->print();
  } else if (daemon && daemon->driven()) {
    unmonitored = daemon->daemonDied();  // the controller has said so
    daemon->print();
  } else {
    std::cout << '\n'
              << (isElsewhere(request.robot) ? "Report of a loop on another computer: darwinop runtime --status there\n"
                                             : reportText({}, {}))
              << reportLine({}, {}) << std::endl;
  }
  return unmonitored && ending.shellStatus() == 0 ? kUnmonitored : ending.shellStatus();
}

}  // namespace darwinop::runtime
