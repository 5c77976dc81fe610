// Parent of runtime and default controller: life cycle and commands. Runtime: supervisor_runtime.cpp
#include "supervisor/supervisor.hpp"

#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "runtime/daemon.hpp"
#include "runtime/robot_notes.hpp"
#include "supervisor/messages.hpp"
#include "supervisor/robot_settings.hpp"
#include "supervisor/standing.hpp"

namespace darwinop::supervisor {
namespace {

runtime::FileLock claim(const std::string& path) {
  listenForOrders();  // before the lock makes this process visible to commands
  if (auto lock = runtime::FileLock::tryTake(path, static_cast<gid_t>(-1), runtime::FileOwner::kOwn))
    return std::move(*lock);
  throw std::runtime_error("a supervisor is already running (" + runtime::pidText(runtime::FileLock::holder(path)) +
                           "); stop it with: darwinop supervisor --stop");
}

const std::string& checkedHome(const std::string& home) {
  struct stat info {};
  if (stat(home.c_str(), &info) != 0 || !S_ISDIR(info.st_mode))
    throw std::runtime_error("folder " + home + " does not exist; specify the installation with --home");
  if (mkdir((home + "/log").c_str(), 0755) != 0 && errno != EEXIST)
    throw std::runtime_error("cannot create " + home + "/log: " + std::strerror(errno) + "; run as root");
  return home;
}

void doze() {
  const timespec pause{0, 20'000'000};
  nanosleep(&pause, nullptr);  // a command ends it early
}

}  // namespace

Supervisor::Supervisor(const Setup& setup)
    : setup_{setup},
      own_{files_},
      claim_{claim(own_.lock)},
      controller_{checkedHome(setup.home), files_},
      logs_{{setup.home + "/log/supervisor.log", setup.home + "/log/controller.log"}},
      start_wait_{kFirstWait} {
  // The record in /dev/shm lasts until the next boot. Without a clean stop, or if the controller was not to run, only a
  // person's command starts it.
  const auto last = readStatus(own_.status);
  if (last && !last->at_rest) {
    controller_.stayEnded(messages::kAfterKill);
    orders_ = last->orders;  // the first record of this supervisor replaces the last one, and counts on
    return;
  }
  if (last && last->stays_ended) controller_.stayEnded(messages::kStaysEnded);
  unlink(own_.status.c_str());  // rest holds no longer, even if no record can be written
}

int Supervisor::run() {
  useRobotFileOf(setup_.home);
  if (const std::string refused = standFast(); !refused.empty()) log(refused);
  log("started, pid " + std::to_string(getpid()) + ", home " + setup_.home);
  now_ = clock_.now();
  startRuntime();
  for (;; doze()) {
    now_ = clock_.now();
    update();
    publishStatus();
    if (phase_ == SupervisorPhase::kOver) break;
  }
  log(messages::kEnded + robot_);
  return failed_ ? runtime::kExitUnderTorque : 0;
}

void Supervisor::update() {
  take(takeOrders());
  if (!hasRuntime(phase_)) controller_.updateWithoutRuntime(now_);
  switch (phase_) {
    case SupervisorPhase::kStarting:
    case SupervisorPhase::kUp:
    case SupervisorPhase::kStopping:
      return updateRuntime();
    case SupervisorPhase::kBackOff:
      if (now_ >= next_start_) startRuntime();
      return;
    case SupervisorPhase::kRescue:
      return updateRescue();
    case SupervisorPhase::kDown:
      if (stop_asked_ && controller_.over()) endAll();
      return;
    case SupervisorPhase::kOver:
    case SupervisorPhase::kCount:
      return;
  }
}

void Supervisor::endAll() {
  phase_ = next(phase_, PhaseEvent::kAllEnded);
  if (!robot_.empty()) return;
  // No loop of this supervisor has run: an earlier one may have left the robot under torque.
  runtime::RobotNotes notes{files_};
  if (notes.held()) noteRobot(~runtime::JointSet{});
  notes.tidy();
}

void Supervisor::onEvent(PhaseEvent event, const std::string& text) {
  phase_ = next(phase_, event);
  state_text_ = text;
  once_.forget();
  log(text);
}

void Supervisor::take(const Orders& orders) {
  orders_ += orders.stop || orders.stop_controller || orders.restart_controller ? 1 : 0;
  if (orders.stop && !stop_asked_) {
    stop_asked_ = true;
    stays_ended_ = controller_.staysEnded();
    restart_asked_ = reset_asked_ = false;
    controller_.stop(now_);
    stop_rescue_at_ = now_ + kTimeToReachRobot;
    if (next(phase_, PhaseEvent::kStopAsked) != phase_) onEvent(PhaseEvent::kStopAsked, "stopping");
  }
  if (stop_asked_) return;
  if (orders.stop_controller) {
    restart_asked_ = reset_asked_ = false;  // the later command counts
    controller_.stop(now_);
  }
  if (!orders.restart_controller) return;
  if (phase_ == SupervisorPhase::kRescue) {
    restart_asked_ = true;  // the robot comes to rest first
    return;
  }
  controller_.restart(now_);
  reset_asked_ = phase_ == SupervisorPhase::kStarting;  // the runtime may have read what an earlier one recorded
  if (phase_ != SupervisorPhase::kDown && phase_ != SupervisorPhase::kBackOff) return;
  runtime::RobotNotes::forget(files_);  // given by a person
  startRuntime();
}

void Supervisor::publishStatus() {
  Status status;
  controller_.report(status, now_);
  status.home = setup_.home;
  status.runtime_pid = runtime_ ? runtime_->process().pid() : 0;
  status.orders = orders_;
  if (phase_ == SupervisorPhase::kOver && failed_) status.left = robot_.substr(kSeparator.size());
  status.at_rest = phase_ == SupervisorPhase::kOver && !failed_;
  status.stopping = stop_asked_;
  status.stays_ended = stays_ended_;
  if (phase_ != SupervisorPhase::kUp) status.state = state_text_;
  if (status == published_) return;
  if (writeStatus(status, own_.status)) published_ = status;
}

}  // namespace darwinop::supervisor
