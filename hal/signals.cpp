#include "hal/signals.hpp"

namespace darwinop {
namespace {

std::atomic<bool> end_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

void ignore(int signal) {
  struct sigaction action {};
  action.sa_handler = SIG_IGN;
  sigaction(signal, &action, nullptr);
}

bool isIgnored(int signal) {
  struct sigaction now {};
  return sigaction(signal, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) == 0 && now.sa_handler == SIG_IGN;
}

}  // namespace

void ignoreSignals() {
  for (const int signal : kIgnoredSignals) ignore(signal);
  for (int signal = SIGRTMIN; signal <= SIGRTMAX; ++signal) ignore(signal);
}

void onEndSignals(void (*handler)(int, siginfo_t*, void*), int flags) {
  ignoreSignals();
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | flags;
  for (const int signal : kEndSignals)
    if (signal != SIGHUP || !isIgnored(SIGHUP)) sigaction(signal, &action, nullptr);
}

sigset_t blockEndSignals() {
  ignoreSignals();
  sigset_t set;
  sigemptyset(&set);
  for (const int signal : kEndSignals)
    if (signal != SIGHUP || !isIgnored(SIGHUP)) sigaddset(&set, signal);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  return set;
}

void endOnSignals() {
  onEndSignals([](int, siginfo_t*, void*) { end_requested.store(true); });
}

const std::atomic<bool>& endRequested() {
  return end_requested;
}

}  // namespace darwinop
