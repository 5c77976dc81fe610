// The default controller's life, once it has begun. What comes before: default_controller_start.cpp
#include "supervisor/default_controller.hpp"

#include <signal.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "runtime/operator.hpp"
#include "safety/fault_book.hpp"

namespace darwinop::supervisor {
namespace {

// step() returns -1 within a cycle; a controller that saves a file then may take a moment.
constexpr Nanos kTimeToEnd{3'000'000'000};

std::string inSeconds(Nanos time) {
  return std::to_string(std::chrono::duration_cast<std::chrono::seconds>(time).count()) + " s";
}

}  // namespace

DefaultController::DefaultController(std::string home, const runtime::RuntimeFiles& files)
    : home_{std::move(home)}, files_{files} {}

void DefaultController::become(State state, const std::string& told) {
  state_ = state;
  told_ = told;
  once_.forget();
  say("default controller: " + told);
}

void DefaultController::look(const Sensors& seen, Nanos now) {
  if (safety::latchedFault(seen.safety.active) != Fault::kNone) latched_at_ = now;
  if (state_ == State::kWaiting && now >= not_before_ && ready(seen, now)) begin(now);
  if (state_ == State::kRunning)
    if (const auto ending = child_->ended()) onEnd(*ending, now);
  if (state_ == State::kHeld) hold();
  if (state_ == State::kEnding) whileEnding(true, now);
}

void DefaultController::lookWithoutRuntime(Nanos now) {
  if (state_ == State::kEnding) whileEnding(false, now);
}

void DefaultController::onEnd(const Ending& ending, Nanos now) {
  child_.reset();
  // Such a fault ends the controller, with whatever code. It has neither done its work nor crashed.
  if (latched_at_ && now - *latched_at_ <= kTimeToEnd)
    return become(State::kWaiting, name_ + " has ended because of a fault that waits for a person");
  switch (policy_.ended(ending, now)) {
    case RestartPolicy::Verdict::kOver:
      return become(State::kOver, name_ +
                                      " has ended by itself; start it again with: darwinop supervisor "
                                      "--restart-controller");
    case RestartPolicy::Verdict::kAgain:
      not_before_ = now + RestartPolicy::kPause;
      return become(State::kWaiting, name_ + " ended " + describe(ending) + "; it is started again in " +
                                         inSeconds(RestartPolicy::kPause));
    case RestartPolicy::Verdict::kGivenUp:
      may_hold_ = true;
      return become(State::kHeld, name_ + " is given up: " + std::to_string(RestartPolicy::kCrashes) +
                                      " crashes within " + inSeconds(RestartPolicy::kWindow) + ", the last one " +
                                      describe(ending) + ". The robot is held as it is, with red lights. See " + home_ +
                                      "/log/controller.log; another chance: darwinop supervisor --restart-controller");
  }
}

void DefaultController::hold() {
  if (!may_hold_) return;
  try {
    if (!holder_) holder_ = std::make_unique<Holder>(files_);
    if (holder_->hold()) return;
    may_hold_ = false;  // who released it does not want it stiff again
    told_ = name_ + " is given up, and the robot is no longer held: " + holder_->whyEnded() +
            ". Another chance: darwinop supervisor --restart-controller";
    say("default controller: " + told_);
    holder_.reset();
  } catch (const std::runtime_error& error) {
    once_.say(std::string{"cannot hold the robot yet: "} + error.what());
  }
}

void DefaultController::end(Nanos now) {
  holder_.reset();  // its farewell lets the robot sit down
  if (state_ == State::kEnding) return;
  if (!child_) return become(State::kOver, "is stopped");
  child_->signal(SIGTERM);
  kill_at_ = now + kTimeToEnd;
  become(State::kEnding, name_ + " is told to end");
}

void DefaultController::whileEnding(bool loop_turns, Nanos now) {
  const auto ending = child_->ended();
  if (!ending && now >= kill_at_) {
    once_.say(name_ + " has not ended within " + inSeconds(kTimeToEnd) + " and is killed");
    child_->signal(SIGKILL);
  }
  if (!ending) return;
  child_.reset();
  if (loop_turns && !ending->tidy()) sitDown();
  if (again_) return restart(now);
  become(State::kOver, name_ + " is stopped");
}

/// A controller that was killed has said no farewell. Somebody who begins and ends at once says it for it.
void DefaultController::sitDown() {
  try {
    const Holder farewell{files_};
  } catch (const std::runtime_error&) {
    return;  // somebody else drives, or nobody can
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
  become(State::kWaiting, "is started anew");
}

/// The order was a person's. A runtime that is not there has nothing to forget.
void DefaultController::resetFaults() {
  latched_at_.reset();
  try {
    runtime::resetFaults(files_);
  } catch (const std::runtime_error&) {
    return;
  }
}

void DefaultController::runtimeLost(Nanos now) {
  if (state_ == State::kOver && !child_) return;
  again_ = false;
  end(now);
}

void DefaultController::tell(Status& status, Nanos now) const {
  const bool chosen = state_ == State::kRunning || state_ == State::kEnding || state_ == State::kHeld;
  status.controller = chosen ? name_ : std::filesystem::path{folder()}.filename().string();
  status.controller_pid = child_ ? child_->pid() : 0;
  status.crashes = policy_.crashes(now);
  status.controller_ended = over();
  status.state = "default controller: " + told_;
}

}  // namespace darwinop::supervisor
