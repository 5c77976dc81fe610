// Records a case of the whole robot: says what to do with the robot, runs an experiment for each recording, looks at it
// at once, and writes the case.json.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "connect/setting.hpp"
#include "core/text/formatted.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/record/recording_check.hpp"
#include "gap_commands.hpp"
#include "gap_files.hpp"
#include "hal/cm730/port_messages.hpp"
#include "hal/process/child_process.hpp"
#include "hal/signals.hpp"
#include "hal/write_text_file.hpp"
#include "safety/config.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;
using connect::RobotKind;

constexpr int kStopped = 130;
constexpr const char* kClamp = "DARWINOP_TWIN_CLAMP";

/// The last signal that asks us to end; 0: none.
std::atomic<int> ended_by{0};
static_assert(std::atomic<int>::is_always_lock_free);
[[nodiscard]] bool isEnded() {
  return ended_by != 0;
}

enum class Answer : std::uint8_t { kGoOn, kRepeat, kStop };

/// A line of the terminal; its end, or a signal, ends the command.
Answer ask(const std::string& question) {
  std::cout << question << std::flush;
  std::string line;
  if (!std::getline(std::cin, line) || line == "q" || isEnded()) return Answer::kStop;
  return line == "r" ? Answer::kRepeat : Answer::kGoOn;
}

class Recorder {
 public:
  Recorder(const Arguments& given, const connect::Setting& robot, std::string model)
      : given_{given},
        is_simulated_{robot.kind == RobotKind::kTwin},
        model_{std::move(model)},
        imu_{twin::readModel(twin::findModel(model_))} {}

  /// False: stopped by the user.
  [[nodiscard]] bool record(const PlannedRecording& plan, std::size_t number, std::size_t of);
  [[nodiscard]] const std::vector<MadeRecording>& made() const { return made_; }

 private:
  [[nodiscard]] bool asks() const { return !given_.yes && !is_simulated_; }
  /// Status of the experiment.
  [[nodiscard]] int run(const PlannedRecording& plan) const;
  [[nodiscard]] std::vector<std::string> look(const PlannedRecording& plan, double session_s);

  const Arguments& given_;
  bool is_simulated_;
  std::string model_;
  RestingImu imu_;
  std::vector<MadeRecording> made_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

int Recorder::run(const PlannedRecording& plan) const {
  if (plan.up)
    setenv(kClamp, text::formatted("%.17g %.17g %.17g", (*plan.up)[0], (*plan.up)[1], (*plan.up)[2]).c_str(), 1);
  else
    unsetenv(kClamp);
  const fs::path recording = fs::path{given_.out} / plan.file;
  fs::remove(recording);  // of a former attempt: the experiment replaces none
  process::Start start{.command = {process::programBeside("darwinop-experiment"), "run", plan.experiment, "--yes",
                                   "--record", recording.string()}};
  if (!given_.robot.empty()) start.command.insert(start.command.end(), {"--robot", given_.robot});
  start.streams = {process::Stream{}, process::Stream::nothing()};  // the plan; what happens is on stderr
  process::ChildProcess experiment{start};
  std::optional<process::Ending> ending;
  // Those of the terminal have also reached the experiment; a second one would end it abruptly.
  for (bool forwarded = false; !(ending = experiment.waitFor(std::chrono::milliseconds{100}));)
    if (const int signal = ended_by; (signal == SIGTERM || signal == SIGPWR) && !std::exchange(forwarded, true))
      experiment.signal(SIGTERM);
  return ending->shellStatus();
}

std::vector<std::string> Recorder::look(const PlannedRecording& plan, double session_s) {
  const std::string path = (fs::path{given_.out} / plan.file).string();
  const auto experiment = experiments::readExperiment(experiments::findExperiment(plan.experiment));
  const double phases_s = experiments::makePlan(experiment, safety::hardRanges()).phases_s;
  try {
    const logs::Log recording = logs::readLog(path);
    MadeRecording made{.plan = plan, .from_s = 0, .to_s = 0, .session_s = session_s, .battery_v = 0};
    findUsedRows(recording, experiment.setup.pose, phases_s, made);
    std::vector<std::string> problems = problemsOf(recording, model_, imu_, made);
    made_.push_back(std::move(made));
    return problems;
  } catch (const std::runtime_error& unusable) {
    return {unusable.what()};
  }
}

bool Recorder::record(const PlannedRecording& plan, std::size_t number, std::size_t of) {
  std::cout << text::formatted("\n%zu of %zu: %s, ", number, of, plan.file.c_str()) << plan.experiment << '\n';
  if (!is_simulated_) std::cout << plan.placing << '\n';
  std::cout.flush();  // the experiment takes minutes
  while (true) {
    if (asks() && ask("Press Enter to start, q to end: ") == Answer::kStop) return false;
    // The servos of a simulated robot are cold again each time.
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - began_;
    const int status = run(plan);
    if (status == kStopped || isEnded()) return false;
    if (status == 2) throw std::runtime_error("the experiment " + plan.experiment + " cannot run, see above");
    if (status != 0 && !asks() && !is_simulated_)  // no person judges whether it may move again
      throw std::runtime_error("the robot ended the experiment " + plan.experiment + ", see above");
    const std::size_t before = made_.size();
    std::vector<std::string> problems = look(plan, is_simulated_ ? 0 : since.count());
    if (status != 0) problems.insert(problems.begin(), "the robot ended the experiment, see above");
    const bool is_usable = made_.size() > before;
    for (const std::string& problem : problems) std::cout << "  " << problem << '\n';
    if (problems.empty()) std::cout << "  good\n";
    if (problems.empty() || (is_usable && !asks())) return true;
    if (!asks()) throw std::runtime_error(plan.file + " cannot be used; find the cause and record the case again");
    const Answer next = ask(is_usable ? "r to repeat it, Enter to keep it, q to end: " : "r to repeat it, q to end: ");
    if (next == Answer::kGoOn && is_usable) return true;
    if (next == Answer::kStop) return false;
    made_.resize(before);
  }
}

/// Name of the model for the case; a file is copied into its folder.
std::string modelFor(const std::string& wanted, const std::string& folder) {
  std::string name = wanted.empty() ? "darwin-op" : wanted;
  const std::string path = twin::findModel(name);
  if (path != name) return name;  // a shipped one
  (void)twin::readModel(path);
  fs::copy_file(path, fs::path{folder} / "model.ini", fs::copy_options::overwrite_existing);
  return "model.ini";
}

connect::Setting settingOf(const std::string& robot) {
  connect::Setting setting = connect::readSetting(robot);
  if (connect::loopIsElsewhere(setting))
    throw std::runtime_error("the loop of this robot runs elsewhere and records itself; give its serial port");
  if (setting.kind == RobotKind::kVirtual)
    throw std::runtime_error("the virtual robot has no weight; use twin, or twin:MODEL");
  if (setting.kind == RobotKind::kSerial) cm730::requirePort(setting.port);  // before anyone clamps it
  return setting;
}

}  // namespace

int recordBody(const Arguments& asked) {
  Arguments given = asked;
  if (const char* const usual = std::getenv("DARWINOP_ROBOT"); given.robot.empty() && usual != nullptr)
    given.robot = usual;
  const connect::Setting robot = settingOf(given.robot);
  const std::string file = newCaseFile(given.out);
  const std::vector<PlannedRecording> plans = plannedRecordings(given.floor);
  for (const PlannedRecording& plan : plans) requireNew(fs::path{given.out} / plan.file);
  fs::create_directories(given.out);
  // Ctrl-C ends the experiment, gently, and then this program.
  onEndSignals([](int number, siginfo_t*, void*) { ended_by = number; });
  const std::string model = modelFor(given.model, given.out);
  const bool is_file = model == "model.ini";
  Recorder recorder{given, robot, is_file ? (fs::path{given.out} / model).string() : model};
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (!recorder.record(plans[i], i + 1, plans.size())) {
      std::cerr << "darwinop gap: stopped; " << given.out << " has no case.json yet\n";
      return kStopped;
    }
  const auto kind = robot.kind == RobotKind::kTwin ? RecordedRobot::kSimulated : RecordedRobot::kPhysical;
  const std::string name = fs::path{given.out}.lexically_normal().filename().string();
  writeTextFile(file, bodyCaseJson(name.empty() ? "robot" : name, model, kind, recorder.made()));
  std::cerr << "darwinop gap: " << given.out << " is the case; next: darwinop gap run " << given.out << '\n';
  return 0;
}

}  // namespace darwinop::gap
