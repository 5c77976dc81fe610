// What signals do to a controller: the table is in hal/signals.hpp.
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

/// What was sent to a whole process group reaches a controller twice: by itself, and handed on by who started it.
/// Nobody presses Ctrl-C a second time as fast as that.
constexpr std::uint32_t kOneRequestMs = 300;

/// Of these a second one ends the program at once: a controller that does not step any more could not be ended else.
constexpr std::array kInsisting{SIGINT, SIGTERM, SIGQUIT};

/// The kernel stops or fails a system call in the background unless these are ignored; a handler would repeat it for
/// ever.
constexpr std::array kOfJobControl{SIGTSTP, SIGTTIN, SIGTTOU};

/// When each signal came first, CLOCK_MONOTONIC in ms, and never 0.
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
    raise(signal);  // comes when this handler is done
  }
  errno = error;
}

/// A terminal that goes away says so more than once.
void onOtherEnd(int) {
  stop_requested.store(true);
}

/// A handler and not SIG_IGN, which programs that the controller starts would inherit.
void onNothing(int) {}

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
