// Ctrl-C and SIGTERM as a flag, so that a controller can end tidily.
#include "webots/stop_signals.hpp"

#include <csignal>

namespace darwinop::facade {

namespace {
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void onSignal(int) {
  stop_requested.store(true);
}
}  // namespace

const std::atomic<bool>& stopRequested() {
  return stop_requested;
}

void installStopSignals() {
  stop_requested = false;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction action {};
    action.sa_handler = onSignal;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    struct sigaction previous {};
    if (sigaction(signal, nullptr, &previous) == 0 && previous.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
}

}  // namespace darwinop::facade
