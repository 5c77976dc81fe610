// Operator commands, received as signals.
#include "supervisor/orders.hpp"

#include <signal.h>

#include <atomic>

#include "hal/signals.hpp"

namespace darwinop::supervisor {
namespace {

// Lock-free: written by the signal handler, read by the loop.
std::atomic<bool> stop_asked{false};
std::atomic<int> last_signal{0};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void handle(int signal, siginfo_t*, void*) {
  if (signal == kStopControllerSignal || signal == kRestartControllerSignal)
    last_signal.store(signal);
  else
    stop_asked.store(true);
}

}  // namespace

void listenForOrders() {
  // SA_RESTART does not apply to the sleep between two checks, which ends early.
  onEndSignals(handle, SA_RESTART);
  struct sigaction action {};
  action.sa_sigaction = handle;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  for (const int signal : {kStopControllerSignal, kRestartControllerSignal}) sigaction(signal, &action, nullptr);
}

Orders takeOrders() {
  const int order = last_signal.exchange(0);
  return {stop_asked.exchange(false), order == kStopControllerSignal, order == kRestartControllerSignal};
}

}  // namespace darwinop::supervisor
