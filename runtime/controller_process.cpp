#include "runtime/controller_process.hpp"

#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <iostream>
#include <optional>

#include "hal/process/child_process.hpp"
#include "hal/signals.hpp"

namespace darwinop::runtime {
namespace {

volatile sig_atomic_t child_pid = 0;
volatile sig_atomic_t hung_up = 0;

/// The terminal sends Ctrl-C to the controller as well; a signal from another process reaches this process only.
void handOn(int signal, siginfo_t* info, void*) {
  const int error = errno;
  if (signal == SIGHUP) hung_up = 1;
  if (child_pid > 0 && info->si_code <= 0) kill(static_cast<pid_t>(child_pid), signal);
  errno = error;
}

/// Blocks SIGCHLD of this thread while it lives, so that sigtimedwait() returns when a child ends.
class ChildSignal {
 public:
  ChildSignal() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGCHLD);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
  }
  ~ChildSignal() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  ChildSignal(const ChildSignal&) = delete;
  ChildSignal& operator=(const ChildSignal&) = delete;

  /// Returns when a child has ended, after another signal, or after 0.2 s.
  void wait() const {
    const timespec at_most{0, 200'000'000};
    (void)sigtimedwait(&set_, nullptr, &at_most);
  }

 private:
  sigset_t set_, before_;
};

void endAfterHangUp(process::ChildProcess& controller, const HangUp& hang_up) {
  std::cerr << "the terminal is closed and the controller does not end: it is ended now" << std::endl;
  controller.signal(SIGINT);
  (void)controller.waitOrKill(hang_up.last_grace);
}

}  // namespace

process::Ending runControllerProcess(const process::Start& start, const HangUp& hang_up,
                                     const std::function<bool()>& keeps_torque) {
  hung_up = 0;
  onEndSignals(handOn);
  const ChildSignal child_signal;
  std::optional<process::ChildProcess> controller;
  {
    const process::SignalsHeld until_the_pid_is_known;
    controller.emplace(start);
    child_pid = controller->pid();
  }
  std::optional<std::chrono::steady_clock::time_point> since;  // the terminal was closed
  while (!controller->ended()) {
    if (hung_up != 0 && !since) since = std::chrono::steady_clock::now();
    if (since && std::chrono::steady_clock::now() - *since >= hang_up.grace && !keeps_torque())
      endAfterHangUp(*controller, hang_up);
    if (!controller->ended()) child_signal.wait();
  }
  child_pid = 0;  // the number may soon be another process's
  return controller->wait();
}

}  // namespace darwinop::runtime
