// Ctrl-C in a Python controller.
#include "apps/python/interrupt.hpp"

#include <Python.h>
#include <signal.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <ctime>

namespace darwinop::python {

namespace {

/// One request may arrive twice within this time, as in webots/stop_signals.cpp.
constexpr std::int64_t kOneRequestMs = 300;

void (*next)(int) = nullptr;
std::atomic<std::int64_t> request_ms{0};  // time of the last request, CLOCK_MONOTONIC; 0: none yet
std::atomic<bool> raised{false};
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal handler sets it");

std::int64_t nowMs() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (static_cast<std::int64_t>(now.tv_sec) * 1000 + now.tv_nsec / 1'000'000) | 1;
}

void onInterrupt(int number) {
  const int error = errno;
  const std::int64_t now_ms = nowMs();
  std::int64_t earlier_ms = request_ms.load();
  const bool same_request = (earlier_ms != 0 && now_ms - earlier_ms <= kOneRequestMs) ||
                            !request_ms.compare_exchange_strong(earlier_ms, now_ms);  // false: another thread has it
  if (!same_request) {
    if (earlier_ms != 0 && Py_IsInitialized() != 0 && !raised.exchange(true))
      PyErr_SetInterruptEx(number);  // may be called by a signal handler
    else
      next(number);
  }
  errno = error;
}

}  // namespace

void installInterrupt() {
  struct sigaction action {};
  if (sigaction(SIGINT, nullptr, &action) != 0 || action.sa_handler == SIG_IGN || action.sa_handler == onInterrupt)
    return;
  next = action.sa_handler;
  request_ms.store(0);
  raised.store(false);
  action.sa_handler = onInterrupt;
  sigaction(SIGINT, &action, nullptr);
}

}  // namespace darwinop::python
