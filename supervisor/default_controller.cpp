// Default controller: state after its start. Before the start: default_controller_start.cpp
#include "supervisor/default_controller.hpp"

#include <signal.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "core/text/number_text.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/operator.hpp"
#include "safety/fault_book.hpp"
#include "supervisor/messages.hpp"

namespace darwinop::supervisor {
namespace {

// step() returns -1 within one cycle; the controller may then need time to save files.
constexpr Nanos kTimeToEnd{3'000'000'000};

}  // namespace

DefaultController::DefaultController(std::string home, const runtime::RuntimeFiles& files)
    : home_{std::move(home)}, files_{files} {}

void DefaultController::become(State state, const std::string& text) {
  state_ = state;
  state_text_ = text;
  once_.forget();
  log("default controller: " + text);
}

void DefaultController::update(const Sensors& seen, Nanos now) {
  if (safety::latchedFault(seen.safety.active) != Fault::kNone) latched_at_ = now;
  if (state_ == State::kWaiting && now >= not_before_ && ready(seen, now)) begin(now);
  if (state_ == State::kRunning)
    if (const auto ending = child_->ended()) onEnd(*ending, now);
  if (state_ == State::kHeld) hold();
  if (state_ == State::kEnding) whileEnding(true, now);
}

void DefaultController::updateWithoutRuntime(Nanos now) {
  if (state_ == State::kEnding) whileEnding(false, now);
}

/// A process that a crashed controller has forked holds the lease with it: no other controller could drive.
void DefaultController::forgetChild(const process::Ending& ending) {
  if (!ending.isNormal()) child_->killRemaining();
  child_.reset();
}

void DefaultController::onEnd(const process::Ending& ending, Nanos now) {
  forgetChild(ending);
  // Such a fault ends the controller with any exit code. It is neither a normal end nor a crash.
  if (latched_at_ && now - *latched_at_ <= kTimeToEnd)
    return become(State::kWaiting, name_ + " has ended because of a fault that needs user action");
  switch (policy_.ended(ending, now)) {
    case RestartPolicy::Verdict::kOver:
      return become(State::kOver,
                    name_ + messages::kEndedByItself + "; restart it with: darwinop supervisor --restart-controller");
    case RestartPolicy::Verdict::kAgain:
      not_before_ = now + RestartPolicy::kPause;
      return become(State::kWaiting,
                    name_ + " ended " + describe(ending) + "; restart in " + text::inSeconds(RestartPolicy::kPause));
    case RestartPolicy::Verdict::kGivenUp:
      may_hold_ = true;
      return become(State::kHeld, name_ + messages::kFailed + std::to_string(RestartPolicy::kCrashes) +
                                      " crashes within " + text::inSeconds(RestartPolicy::kWindow) + ", the last one " +
                                      describe(ending) + ". The robot holds its pose, with red lights; see " + home_ +
                                      "/log/controller.log; restart it with: darwinop supervisor --restart-controller");
  }
}

void DefaultController::hold() {
  if (!may_hold_) return;
  // Asked first: an attempt to take the lease waits for 0.1 s, in which nothing watches the runtime.
  if (const pid_t driver = holder_ ? 0 : runtime::FileLock::holder(files_.drive_lock); driver != 0)
    return once_.log(messages::kOtherDrives + runtime::pidText(driver));
  try {
    if (!holder_) holder_ = std::make_unique<Holder>(files_);
    if (holder_->hold()) return;
    may_hold_ = false;  // after a release by a person the robot must not be held again
    state_text_ = name_ + " has failed, and the robot is no longer held: " + holder_->whyEnded() +
                  "; restart it with: darwinop supervisor --restart-controller";
    log("default controller: " + state_text_);
    holder_.reset();
  } catch (const std::runtime_error& error) {
    once_.log(std::string{messages::kCannotHold} + error.what());
  }
}

void DefaultController::end(Nanos now) {
  holder_.reset();  // its end of session lets the robot sit down
  if (state_ == State::kEnding) return;
  if (!child_) return become(State::kOver, "stopped");
  child_->signal(SIGTERM);
  kill_at_ = now + kTimeToEnd;
  become(State::kEnding, name_ + " ending");
}

void DefaultController::whileEnding(bool loop_turns, Nanos now) {
  const auto ending = child_->ended();
  if (!ending && now >= kill_at_) {
    once_.log(name_ + " has not ended within " + text::inSeconds(kTimeToEnd) + messages::kKilled);
    child_->signalGroup(SIGKILL);
  }
  if (!ending) return;
  forgetChild(*ending);
  if (loop_turns && !ending->isNormal()) endSession();
  if (again_) return restart(now);
  become(State::kOver, name_ + messages::kStopped);
}

/// A killed controller has not ended its session; a short session of our own does that.
void DefaultController::endSession() {
  try {
    const Holder session{files_};
  } catch (const std::runtime_error&) {
    return;  // another process drives, or none can
  }
}

void DefaultController::stop(Nanos now) {
  again_ = false;
  policy_.forget();
  end(now);
}

void DefaultController::restart(Nanos now) {
  policy_.forget();
  again_ = child_ != nullptr;
  if (again_) return end(now);
  holder_.reset();
  resetFaults();
  not_before_ = now;
  in_pose_since_.reset();
  become(State::kWaiting, "restarting");
}

/// Releases are cleared as well. What an earlier loop has recorded of them is a matter of the supervisor.
void DefaultController::resetFaults() {
  latched_at_.reset();
  try {
    runtime::requestFaultReset(files_);
  } catch (const std::runtime_error&) {
    return;
  }
}

void DefaultController::runtimeLost(Nanos now) {
  if (state_ == State::kOver && !child_) return;
  again_ = false;
  end(now);
}

void DefaultController::report(Status& status, Nanos now) const {
  const bool chosen = state_ == State::kRunning || state_ == State::kEnding || state_ == State::kHeld;
  status.controller = chosen ? name_ : std::filesystem::path{folder()}.filename().string();
  status.controller_pid = child_ ? child_->pid() : 0;
  status.crashes = policy_.crashes(now);
  status.controller_ended = over();
  status.state = "default controller: " + state_text_;
}

}  // namespace darwinop::supervisor
