// Runtime supervision: start, monitoring, end, and rescue.
#include <signal.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "runtime/daemon.hpp"
#include "runtime/messages.hpp"
#include "runtime/rest.hpp"
#include "runtime/robot_notes.hpp"
#include "safety/fault_book.hpp"
#include "supervisor/child_start.hpp"
#include "supervisor/messages.hpp"
#include "supervisor/rescue_watch.hpp"
#include "supervisor/robot_settings.hpp"
#include "supervisor/standing.hpp"
#include "supervisor/supervisor.hpp"

namespace darwinop::supervisor {
namespace {

// A failed start (invalid robot.ini, silent servo) is retried at growing intervals.
constexpr Nanos kLongestStartWait{60'000'000'000};
// In addition to the crouch (runtime/rest.cpp): time to write a recording and end the process.
constexpr Nanos kTimeToStop{5'000'000'000};
// A loop that stops while ending gets this time to end its process.
constexpr Nanos kLastMoment{2'000'000'000};

}  // namespace

void Supervisor::startRuntime() {
  process::Start start = childStart({setup_.runtime_program, "--wait"});
  try {
    // Read now, so that the rescue uses the runtime's settings even if the file changes. With an invalid file nothing
    // may move, and no runtime is started.
    settings_ = readRobotSettings();
    runtime_ = std::make_unique<RuntimeChild>(start, files_);
  } catch (const std::runtime_error& error) {
    return backOff(std::string{"runtime: cannot start: "} + error.what());
  }
  failed_ = false;
  robot_.clear();
  onEvent(PhaseEvent::kStarted, "runtime: started (pid " + std::to_string(runtime_->process().pid()) + ")");
}

/// Logs the reason once until it changes.
void Supervisor::backOff(const std::string& why) {
  next_start_ = now_ + start_wait_;
  start_wait_ = std::min(2 * start_wait_, kLongestStartWait);
  if (phase_ != SupervisorPhase::kBackOff || state_text_ != why) onEvent(PhaseEvent::kStartFailed, why);
}

void Supervisor::updateRuntime() {
  const RuntimeChild::State state = runtime_->update(now_);
  if (state == RuntimeChild::State::kEnded) return onRuntimeEnd(*runtime_->process().ended());
  if (state == RuntimeChild::State::kSilent && kill_at_ != Nanos{0}) kill_at_ = std::min(kill_at_, now_ + kLastMoment);
  if (state == RuntimeChild::State::kSilent && kill_at_ == Nanos{0})
    return rescue("runtime: hung, no cycle for " + std::to_string(runtime_->patience().count() / 1'000'000) + " ms");
  if (state != RuntimeChild::State::kStarting) {
    if (phase_ == SupervisorPhase::kStarting) {
      noteIdentity(settings_);
      controller_.startsFrom(safety::startPose(runtime_->safety()));
      onEvent(PhaseEvent::kFirstCycle, messages::kRuntimeReady);
      if (std::exchange(reset_asked_, false)) controller_.resetFaults();
    }
    start_wait_ = kFirstWait;
    controller_.update(runtime_->sensors(), now_);
  } else {
    controller_.updateWithoutRuntime(now_);
  }
  if (phase_ == SupervisorPhase::kStopping && controller_.over()) endRuntime();
}

void Supervisor::endRuntime() {
  if (kill_at_ == Nanos{0}) {
    const runtime::Rest rest{settings_.serial.safety, settings_.serial.period};
    kill_at_ = now_ + rest.atMost(runtime_->sensors()) + kTimeToStop;
    runtime_->process().signal(SIGTERM);
  }
  if (now_ >= kill_at_) rescue("runtime: has not ended in time");
}

void Supervisor::onRuntimeEnd(const process::Ending& ending) {
  const bool was_up = runtime_->wasUp();
  kill_at_ = Nanos{0};
  const bool under_torque = !ending.by_signal && ending.code == runtime::kExitUnderTorque;
  if (was_up && !ending.isNormal() && !under_torque) return rescue("runtime: died " + describe(ending));
  const Sensors& last = runtime_->sensors();
  if (was_up) {
    const runtime::JointSet left = runtime::perhapsUnderTorque(last, runtime::everAnswered(last));
    noteRobot(!under_torque ? runtime::JointSet{} : left.none() ? ~left : left);
  }
  runtime_.reset();
  if (was_up || stop_asked_) controller_.runtimeLost(now_);
  if (stop_asked_) return onEvent(PhaseEvent::kEnded, "runtime: ended" + robot_);
  if (was_up || ending.isNormal())
    return onEvent(PhaseEvent::kEnded, "runtime: ended by another process" + robot_ +
                                           "; restart it with: darwinop supervisor --restart-controller");
  backOff("runtime: start failed (" + describe(ending) + "); next attempt in " +
          std::to_string(start_wait_ / Nanos{1'000'000'000}) + " s");
}

void Supervisor::noteRobot(const runtime::JointSet& under_torque) {
  failed_ = under_torque.any();
  robot_ = failed_ ? std::string{kSeparator} + runtime::messages::kUnderTorque + runtime::namesOf(under_torque)
                   : messages::kAtRest;
}

void Supervisor::rescue(const std::string& why) {
  onEvent(PhaseEvent::kLost, why + messages::kRescues + "hold, slow crouch, torque off");
  kill_at_ = Nanos{0};
  runtime_->process().signal(SIGKILL);
  controller_.runtimeLost(now_);
  present_ = runtime::everAnswered(runtime_->sensors());
  stop_rescue_at_ = now_ + kTimeToReachRobot;
  standDown();
  rescue_ = std::make_unique<Rescue>(settings_, files_, safety::keptLimp(runtime_->sensors().safety.active));
}

void Supervisor::updateRescue() {
  (void)runtime_->process().ended();  // reaped: this releases the port and its lock
  const Rescue::Step step = rescue_->update(now_);
  if (!rescue_->obstacle().empty()) once_.log(messages::kCannotReachRobot + rescue_->obstacle());
  if (step == Rescue::Step::kAtRest || step == Rescue::Step::kStiff) return onRest(step);
  if (rescue_->online()) stop_rescue_at_ = now_ + kTimeToReachRobot;
  if (!stop_asked_ || now_ < stop_rescue_at_ || !controller_.over()) return;
  noteRobot(present_.none() ? ~present_ : present_);
  rescue_.reset();
  onEvent(PhaseEvent::kRescueEnded, "rescue: stopped before it could reach the robot" + robot_);
}

void Supervisor::onRest(Rescue::Step step) {
  const Sensors last = rescue_->sensors();
  const runtime::JointSet left = runtime::perhapsUnderTorque(last, present_ | runtime::everAnswered(last));
  noteRobot(step == Rescue::Step::kStiff && left.none() ? ~left : left);
  rescue_.reset();
  runtime_.reset();
  onEvent(PhaseEvent::kRescueEnded,
          (failed_ ? "rescue: the robot sits" + robot_ : std::string{messages::kRescued}) +
              std::string{"; restart at the next boot, or with: darwinop supervisor --restart-controller"});
  if (const std::string refused = standFast(); !refused.empty()) log(refused);
  if (!std::exchange(restart_asked_, false)) return;
  controller_.restart(now_);
  runtime::RobotNotes::forget(files_);
  startRuntime();
}

}  // namespace darwinop::supervisor
