#include "experiment_run.hpp"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <bitset>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <webots/Motor.hpp>

#include "connect/robot_file.hpp"
#include "connect/setting.hpp"
#include "exit_codes.hpp"
#include "experiments/format/experiment_files.hpp"
#include "experiments/format/plan.hpp"
#include "experiments/format/reader.hpp"
#include "experiments/run/gentle_stop.hpp"
#include "experiments/run/hardware.hpp"
#include "experiments/run/progress.hpp"
#include "experiments/run/recorded.hpp"
#include "experiments/run/runner.hpp"
#include "experiments/run/shortfalls.hpp"
#include "runtime/recording_file.hpp"
#include "webots/robot_impl.hpp"
#include "webots/stop_signals.hpp"
#include "webots/tool_robot.hpp"

namespace darwinop::experiments {
namespace {

constexpr const char* kUpright = "0 1 0";  // of a clamped twin, where nothing else is set

/// Ranges and absent joints of this robot, as far as a file says them: robot.ini.
safety::Config safetyOf(const connect::Setting& robot) {
  if (robot.kind != connect::RobotKind::kSerial) return {};
  return connect::safetyOn(connect::readRobotFile(), {}, "config.ini");
}

/// Throws std::runtime_error if the experiment names a joint that is absent. With `all` it means those that are
/// present.
void requireJoints(const Experiment& experiment, const Plan& plan, const std::bitset<kJoints>& absent) {
  std::bitset<kJoints> moved, recorded;
  for (const JointPlan& joint : plan.moved) moved.set(index(joint.joint));
  for (const Joint joint : experiment.record_joints) recorded.set(index(joint));
  for (const std::bitset<kJoints>& named : {moved, recorded})
    for (std::size_t i = 0; !named.all() && i < kJoints; ++i)
      if (named[i] && absent[i])
        throw std::runtime_error(experiment.file + ": " + std::string{kJointTable[i].name} + kNamesAbsentJoint);
}

/// "speed-20260102-150405-twin.csv"; "-2" and so on before ".csv" if that exists.
std::string logName(const Experiment& experiment, const std::string& robot) {
  char date[32];
  const time_t now = time(nullptr);
  tm local{};
  localtime_r(&now, &local);
  strftime(date, sizeof date, "-%Y%m%d-%H%M%S-", &local);
  std::string name = robot.empty() ? "robot" : std::filesystem::path{robot}.stem().string();
  std::ranges::replace_if(
      name, [](unsigned char c) { return std::isalnum(c) == 0; }, '-');
  const std::string base = experiment.name + date + name;
  std::string free = base + ".csv";
  for (int i = 2; std::filesystem::exists(free); ++i) free = base + "-" + std::to_string(i) + ".csv";
  return free;
}

void setIfGiven(const char* name, const std::string& value) {
  if (!value.empty()) setenv(name, value.c_str(), 1);
}

Pose goalsOf(webots::Robot& robot) {
  Pose goals{};
  for (std::size_t i = 0; i < kJoints; ++i)
    goals[i] = robot.getMotor(std::string{kJointTable[i].name})->getTargetPosition();
  return goals;
}

/// On the robot selected by the environment; on return the robot is at rest and the recording complete.
RunOutcome drive(const Experiment& experiment, const Plan& plan, Shortfalls& shortfalls) {
  webots_api::ToolRobot robot{{.trunk_is_held = experiment.setup.is_clamped}};
  const std::atomic<bool>& stop = installGentleStop();
  Progress progress{plan.seconds()};
  const auto report = [&](const std::string& phase, double seconds) {
    progress.update(phase, seconds);
    if (phase == kSetupPhase || phase == kReturnPhase) return;
    shortfalls.update(goalsOf(robot), webots_api::currentRobot()->session().sensors());
  };
  return Runner{robot, experiment, stop, report}.run();
}

/// False: it was not done as asked.
bool reportShortfalls(const Shortfalls& shortfalls, bool allows_clamped) {
  const std::string unmeasured = shortfalls.unmeasuredText(), clamped = shortfalls.clampedText();
  std::cerr << unmeasured << clamped;
  return unmeasured.empty() && (clamped.empty() || allows_clamped);
}

int reportEnd(RunOutcome outcome, const Shortfalls& shortfalls, const ExperimentRequest& asked) {
  const std::string& record = asked.record;
  const bool is_recorded = reportRecording(record);
  // The API answers a second request as the end of the robot.
  if (outcome == RunOutcome::kEnded && webots_api::stopRequested()) outcome = RunOutcome::kStopped;
  switch (outcome) {
    case RunOutcome::kStopped:
      std::cerr << kStoppedOnRequest << (is_recorded && !record.empty() ? kRecordedUntilThen : "") << '\n';
      return app::kStopped;
    case RunOutcome::kEnded:
      std::cerr << "the experiment was ended by the robot, see above\n";
      return app::kFailed;
    case RunOutcome::kFell:
      std::cerr << "the robot fell before the first pose; nothing was measured. Set it upright on level floor, "
                   "in its start pose, and try again\n";
      return app::kFailed;
    case RunOutcome::kFellIn:
      std::cerr << "unexpected fall: the experiment was ended, and the recording is invalid from "
                   "the fall on\n";
      return app::kFailed;
    default:
      return reportShortfalls(shortfalls, asked.allows_clamped) && is_recorded ? app::kDone : app::kFailed;
  }
}

}  // namespace

int run(ExperimentRequest a) {
  runtime::requireNewRecording(a.record);
  const Experiment experiment = readExperiment(findExperiment(a.experiment));
  if (const char* usual = std::getenv("DARWINOP_ROBOT"); a.robot.empty() && usual != nullptr) a.robot = usual;
  const connect::Setting robot = connect::readSetting(a.robot);
  const safety::Config safety = safetyOf(robot);
  const Plan plan = makePlan(experiment, safety.range);
  requireJoints(experiment, plan, safety.absent);
  std::cout << planText(experiment, plan) << std::endl;
  if (!a.yes && mayBeHardware(a.robot)) {
    std::cerr << "darwinop experiment: this moves a real robot, as shown above. Make sure that nothing is in its way "
                 "and that "
                 "a person holds it, then add --yes\n";
    return app::kNeedsYes;
  }
  if (connect::loopIsElsewhere(robot) && !a.no_record)
    throw std::runtime_error(
        "the loop of this robot runs in the daemon, which writes recordings itself: start it with darwinop runtime "
        "--record FILE, and run the experiment with --no-record");
  if (a.record.empty() && !a.no_record) a.record = logName(experiment, a.robot);
  setIfGiven("DARWINOP_ROBOT", a.robot);
  if (a.period_ms != 0) setIfGiven("DARWINOP_PERIOD_MS", std::to_string(a.period_ms));
  unsetenv("DARWINOP_RECORD");
  setIfGiven("DARWINOP_RECORD", a.record);
  setIfGiven("DARWINOP_RECORD_NOTES", recordNotes(experiment));
  if (experiment.setup.is_clamped) setenv("DARWINOP_TWIN_CLAMP", kUpright, 0);
  setenv("DARWINOP_KEEP_CWD", "1", 1);  // file names are relative to the user's folder
  Shortfalls shortfalls{plan, experiment.record_joints, safety.absent};
  const RunOutcome outcome = drive(experiment, plan, shortfalls);
  return reportEnd(outcome, shortfalls, a);
}

}  // namespace darwinop::experiments
