// The first Ctrl-C of an experiment: it ends, and the robot goes back slowly. The second is the API's.
#include "experiments/run/gentle_stop.hpp"

#include <array>
#include <csignal>
#include <cstddef>

#include "hal/signals.hpp"

namespace darwinop::experiments {
namespace {

std::atomic<bool> stop_asked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

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
  stop_asked.store(true);
  // A terminal that goes away says SIGHUP twice; that is not a user who insists.
  for (Before& one : handlers_before)
    if (one.signal != SIGHUP && one.action.sa_handler != SIG_IGN) sigaction(one.signal, &one.action, nullptr);
}

}  // namespace

const std::atomic<bool>& installGentleStop() {
  stop_asked = false;
  for (Before& one : handlers_before) {
    sigaction(one.signal, nullptr, &one.action);
    if (one.action.sa_handler == SIG_IGN) continue;  // as whoever started the program wanted it
    struct sigaction action {};
    action.sa_handler = onSignal;
    sigaction(one.signal, &action, nullptr);
  }
  return stop_asked;
}

}  // namespace darwinop::experiments
