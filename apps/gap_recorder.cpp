#include "gap_recorder.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <utility>

#include "core/text/formatted.hpp"
#include "exit_codes.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/logs/read_log.hpp"
#include "gap/record/kept_recording.hpp"
#include "gap/record/recording_check.hpp"
#include "hal/process/child_process.hpp"
#include "runtime/recording_file.hpp"
#include "safety/config.hpp"

namespace darwinop::gap {
namespace {

namespace fs = std::filesystem;

constexpr const char* kClamp = "DARWINOP_TWIN_CLAMP";

enum class Answer : std::uint8_t { kGoOn, kRepeat, kStop };

/// A line of the terminal; its end, or a signal, ends the command.
Answer ask(const std::string& question, const std::atomic<int>& end_signal) {
  std::cout << question << std::flush;
  std::string line;
  if (!std::getline(std::cin, line) || line == "q" || end_signal != 0) return Answer::kStop;
  return line == "r" ? Answer::kRepeat : Answer::kGoOn;
}

}  // namespace

BodyRecorder::BodyRecorder(const Arguments& given, std::string twin, std::string model,
                           const std::atomic<int>& end_signal)
    : given_{given},
      twin_{std::move(twin)},
      model_{std::move(model)},
      end_signal_{end_signal},
      imu_{twin::readModel(twin::findModel(model_))} {}

/// Since the first recording began. The servos of a simulated robot are cold again each time.
double BodyRecorder::sessionSeconds() const {
  const std::chrono::duration<double> here = std::chrono::steady_clock::now() - began_;
  return isSimulated() ? 0 : earlier_s_ + here.count();
}

int BodyRecorder::run(const PlannedRecording& plan, const std::string& file) const {
  if (plan.up)
    setenv(kClamp, text::formatted("%.17g %.17g %.17g", (*plan.up)[0], (*plan.up)[1], (*plan.up)[2]).c_str(), 1);
  else
    unsetenv(kClamp);
  fs::remove(file);  // of a former attempt: the experiment replaces none
  process::Start start{.command = {process::programBeside("darwinop-experiment"), "run", plan.experiment, "--yes",
                                   "--allow-clamped",  // the recording has the goals as sent
                                   "--record", file}};
  if (!given_.robot.empty()) start.command.insert(start.command.end(), {"--robot", given_.robot});
  start.streams = {process::Stream{}, process::Stream::nothing()};  // the plan; what happens is on stderr
  process::ChildProcess experiment{start};
  std::optional<process::Ending> ending;
  // Those of the terminal have also reached the experiment; a second one would end it abruptly.
  for (bool forwarded = false; !(ending = experiment.waitFor(std::chrono::milliseconds{100}));)
    if (const int signal = end_signal_; (signal == SIGTERM || signal == SIGPWR) && !std::exchange(forwarded, true))
      experiment.signal(SIGTERM);
  return ending->shellStatus();
}

std::vector<std::string> BodyRecorder::look(const PlannedRecording& plan, const std::string& file, double session_s) {
  const auto experiment = experiments::readExperiment(experiments::findExperiment(plan.experiment));
  const double phases_s = experiments::makePlan(experiment, safety::hardRanges()).phases_s;
  try {
    const logs::Log recording = logs::readLog(file);
    MadeRecording made{.plan = plan, .from_s = 0, .to_s = 0, .session_s = session_s, .battery_v = 0};
    findUsedRows(recording, experiment.setup.pose, phases_s, made);
    std::vector<std::string> problems = problemsOf(recording, model_, imu_, made);
    // Of a physical robot a port and what it has found: either may have changed.
    const std::string robot = robotOf(recording);
    if (robot_.empty()) robot_ = robot;
    if (robot != robot_) problems.push_back(messages::kOfAnotherRobot + robot + messages::kEarlierOnesAreOf + robot_);
    made_.push_back(std::move(made));
    return problems;
  } catch (const std::runtime_error& unusable) {
    return {unusable.what()};
  }
}

std::vector<std::string> BodyRecorder::problems(int status, const PlannedRecording& plan, const std::string& file,
                                                double session_s) {
  const std::string experiment = "the experiment " + plan.experiment;
  if (status == app::kWrong) {
    if (!asks()) throw std::runtime_error(experiment + " cannot run, see above");
    return {experiment + " cannot run, see above"};
  }
  if (!runtime::isCompleteRecording(file)) {
    const int signal = status - 128;  // as shells count
    const std::string why =
        signal > 0 ? experiment + messages::kEndedBySignal + std::to_string(signal) : file + messages::kIncomplete;
    if (!asks()) throw RecordingFailed(why);
    return {why};
  }
  if (status != 0 && !asks() && !isSimulated())  // no person judges whether it may move again
    throw RecordingFailed(experiment + messages::kNotAsAsked);
  std::vector<std::string> problems = look(plan, file, session_s);
  if (status != 0) problems.insert(problems.begin(), experiment + messages::kNotAsAsked);
  return problems;
}

std::string BodyRecorder::fileOf(const PlannedRecording& plan) const {
  return (fs::path{given_.out} / plan.file).string();
}

const MadeRecording* BodyRecorder::find(const PlannedRecording& plan) const {
  const auto found = std::ranges::find_if(made_, [&](const MadeRecording& one) { return one.plan.file == plan.file; });
  return found == made_.end() ? nullptr : &*found;
}

bool BodyRecorder::isTurnedBetween(const std::vector<PlannedRecording>& plans) const {
  const PlannedRecording* first = nullptr;
  for (const PlannedRecording& plan : plans) {
    if (find(plan) != nullptr) continue;
    if (first != nullptr && (plan.setup != first->setup || plan.up != first->up)) return true;
    if (first == nullptr) first = &plan;
  }
  return false;
}

bool BodyRecorder::record(const std::vector<PlannedRecording>& plans) {
  if (given_.yes && !isSimulated() && isTurnedBetween(plans)) throw std::runtime_error(messages::kNeedsTurning);
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (find(plans[i]) != nullptr) continue;
    if (isEnded()) return false;  // it came while no experiment ran, which would have received it
    std::cout << text::formatted("\n%zu of %zu: %s, ", i + 1, plans.size(), plans[i].file.c_str())
              << plans[i].experiment << '\n';
    if (!record(plans[i])) return false;
  }
  return true;
}

std::vector<MadeRecording> BodyRecorder::made(const std::vector<PlannedRecording>& plans) const {
  std::vector<MadeRecording> in_order;
  for (const PlannedRecording& plan : plans)
    if (const MadeRecording* const one = find(plan)) in_order.push_back(*one);
  return in_order;
}

bool BodyRecorder::record(const PlannedRecording& plan) {
  if (!isSimulated()) std::cout << plan.placing << '\n';
  std::cout.flush();  // the experiment takes minutes
  const std::string file = fileOf(plan), attempt = fs::path{file}.replace_extension(".attempt.csv").string();
  while (true) {
    if (asks() && ask("Press Enter to start, q to end: ", end_signal_) == Answer::kStop) return false;
    if (isEnded()) return false;
    const double session_s = sessionSeconds();
    const int status = run(plan, attempt);
    if (status == app::kStopped || isEnded()) return false;
    const std::size_t before = made_.size();
    const std::vector<std::string> wrong = problems(status, plan, attempt, session_s);
    const bool is_usable = made_.size() > before;
    for (const std::string& problem : wrong) std::cout << "  " << problem << '\n';
    if (wrong.empty()) std::cout << "  good\n";
    bool is_kept = wrong.empty() || (is_usable && isSimulated());
    if (!is_kept && !asks())
      throw RecordingFailed(attempt + messages::kUnusable + (given_.add.empty() ? " with --resume" : ""));
    if (!is_kept) {
      const Answer next =
          ask(is_usable ? "r to repeat it, Enter to keep it, q to end: " : "r to repeat it, q to end: ", end_signal_);
      if (next == Answer::kStop) return false;
      is_kept = next == Answer::kGoOn && is_usable;
    }
    if (is_kept) {
      fs::rename(attempt, file);
      return true;
    }
    made_.resize(before);
  }
}

}  // namespace darwinop::gap
