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
std::atomic<std::int64_t> first_ms{0};  // 0: none yet
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
  std::int64_t earlier_ms = 0;
  const bool first = first_ms.compare_exchange_strong(earlier_ms, now_ms);
  if (!first && now_ms - earlier_ms > kOneRequestMs && Py_IsInitialized() != 0 && !raised.exchange(true)) {
    first_ms.store(now_ms);
    PyErr_SetInterruptEx(number);  // may be called by a signal handler
  } else {
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
  first_ms.store(0);
  raised.store(false);
  action.sa_handler = onInterrupt;
  sigaction(SIGINT, &action, nullptr);
}

}  // namespace darwinop::python
