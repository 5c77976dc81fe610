// Signal handling of an experiment: the first signal ends it with a slow return, the second is handled by the API.
#include "experiments/run/gentle_stop.hpp"

#include <array>
#include <csignal>
#include <cstddef>

#include "hal/signals.hpp"

namespace darwinop::experiments {
namespace {

std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set in a signal handler");

struct Before {
  int signal;
  struct sigaction action;
};
std::array<Before, kEndSignals.size()> handlers_before = [] {
  std::array<Before, kEndSignals.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i].signal = kEndSignals[i];
  return all;
}();

void onSignal(int) {
  stop_requested.store(true);
  // A closing terminal sends SIGHUP twice; the second must not count as a second request.
  for (Before& one : handlers_before)
    if (one.signal != SIGHUP && one.action.sa_handler != SIG_IGN) sigaction(one.signal, &one.action, nullptr);
}

}  // namespace

const std::atomic<bool>& installGentleStop() {
  stop_requested = false;
  for (Before& one : handlers_before) {
    sigaction(one.signal, nullptr, &one.action);
    if (one.action.sa_handler == SIG_IGN) continue;  // ignored by the parent process
    struct sigaction action {};
    action.sa_handler = onSignal;
    sigaction(one.signal, &action, nullptr);
  }
  return stop_requested;
}

}  // namespace darwinop::experiments
