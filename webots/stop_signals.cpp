// Ctrl-C, SIGTERM and SIGHUP as a flag, so that a controller can end tidily; SIGPIPE without effect.
#include "webots/stop_signals.hpp"

#include <csignal>

namespace darwinop::facade {

namespace {
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void onSignal(int) {
  stop_requested.store(true);
}

/// A handler and not SIG_IGN, which programs that the controller starts would inherit.
void onBrokenPipe(int) {}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

/// What the program or its parent chose for this signal; flags do not matter.
bool has(int signal, void (*handler)(int)) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler == handler;
}
}  // namespace

const std::atomic<bool>& stopRequested() {
  return stop_requested;
}

void installStopSignals() {
  stop_requested = false;
  for (const int signal : {SIGINT, SIGTERM})
    if (!has(signal, SIG_IGN)) handle(signal, onSignal, static_cast<int>(SA_RESETHAND));
  // A terminal that goes away says so twice, through the kernel and the shell; that is not a user who insists.
  if (!has(SIGHUP, SIG_IGN)) handle(SIGHUP, onSignal, 0);
  if (has(SIGPIPE, SIG_DFL)) handle(SIGPIPE, onBrokenPipe, SA_RESTART);
}

}  // namespace darwinop::facade
