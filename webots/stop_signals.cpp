// Signal handling of controllers. Table: hal/signals.hpp.
#include "webots/stop_signals.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <ctime>

#include "hal/signals.hpp"

namespace darwinop::webots_api {

namespace {
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

/// A signal to the process group reaches a controller twice: directly, and forwarded by its parent. Two signals within
/// this time count as one request.
constexpr std::uint32_t kOneRequestMs = 300;

/// A second one of these ends the program at once: a controller that hangs could not be ended otherwise.
constexpr std::array kInsisting{SIGINT, SIGTERM, SIGQUIT};

/// Terminal access from the background stops or fails unless these are ignored; a handler would restart the call for
/// ever.
constexpr std::array kOfJobControl{SIGTSTP, SIGTTIN, SIGTTOU};

/// Time of the first signal of each number, CLOCK_MONOTONIC, ms; 0: none yet.
std::array<std::atomic<std::uint32_t>, NSIG> came_ms{};
static_assert(std::atomic<std::uint32_t>::is_always_lock_free, "a signal handler sets it");

std::uint32_t nowMs() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (static_cast<std::uint32_t>(now.tv_sec) * 1000 + static_cast<std::uint32_t>(now.tv_nsec / 1'000'000)) | 1;
}

void onSignal(int signal) {
  const int error = errno;
  stop_requested.store(true);
  const std::uint32_t now_ms = nowMs();
  std::uint32_t first_ms = 0;
  if (!came_ms.at(static_cast<std::size_t>(signal)).compare_exchange_strong(first_ms, now_ms) &&
      now_ms - first_ms > kOneRequestMs) {
    std::signal(signal, SIG_DFL);
    raise(signal);  // delivered after this handler returns
  }
  errno = error;
}

/// For signals of which a second one does not end the program: a closed terminal sends several.
void onOtherEnd(int) {
  stop_requested.store(true);
}

/// A handler instead of SIG_IGN, which programs started by the controller would inherit.
void onNothing(int) {}

void handle(int signal, void (*handler)(int), int flags) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

/// True if `handler` is installed for this signal, with any flags.
bool has(int signal, void (*handler)(int)) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler == handler;
}

bool isAmong(const auto& signals, int signal) {
  return std::ranges::find(signals, signal) != signals.end();
}

void ignore(int signal) {
  if (has(signal, SIG_DFL)) handle(signal, isAmong(kOfJobControl, signal) ? SIG_IGN : onNothing, SA_RESTART);
}
}  // namespace

const std::atomic<bool>& stopRequested() {
  return stop_requested;
}

void installStopSignals() {
  stop_requested = false;
  for (const int signal : kEndSignals) {
    came_ms.at(static_cast<std::size_t>(signal)) = 0;
    if (!has(signal, SIG_IGN)) handle(signal, isAmong(kInsisting, signal) ? onSignal : onOtherEnd, 0);
  }
  for (const int signal : kIgnoredSignals) ignore(signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) ignore(signal);
}

}  // namespace darwinop::webots_api
