// Effect of each signal on programs that drive or observe a robot. User table: docs/threads.md.
#pragma once

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace darwinop {

enum class SignalEffect {
  kEnds,      // normal end: the robot comes to rest first
  kIgnored,   // no effect; the default would end or stop the process
  kNoEffect,  // default action, which changes nothing
  kKills,     // ends the process at once (defect of the program, kill -9); the supervisor then rescues the robot
  kStops,     // cannot be caught: the process is stopped; the supervisor then rescues the robot
};

struct SignalRow {
  int number;
  std::string_view name;
  SignalEffect effect;
  std::string_view comes_when;
};

/// The 31 signals of Linux on x86.
inline constexpr std::array<SignalRow, 31> kSignals{{
    {SIGHUP, "SIGHUP", SignalEffect::kEnds, "terminal or ssh session closed; ignored under nohup"},
    {SIGINT, "SIGINT", SignalEffect::kEnds, "Ctrl-C"},
    {SIGQUIT, "SIGQUIT", SignalEffect::kEnds, "Ctrl-\\"},
    {SIGILL, "SIGILL", SignalEffect::kKills, "defect: illegal instruction"},
    {SIGTRAP, "SIGTRAP", SignalEffect::kKills, "breakpoint without a debugger"},
    {SIGABRT, "SIGABRT", SignalEffect::kKills, "defect: assert, uncaught exception"},
    {SIGBUS, "SIGBUS", SignalEffect::kKills, "defect; a truncated shared file is handled"},
    {SIGFPE, "SIGFPE", SignalEffect::kKills, "defect: integer division by zero"},
    {SIGKILL, "SIGKILL", SignalEffect::kKills, "kill -9, or out of memory"},
    {SIGUSR1, "SIGUSR1", SignalEffect::kIgnored, "kill -USR1"},
    {SIGSEGV, "SIGSEGV", SignalEffect::kKills, "defect: invalid memory access"},
    {SIGUSR2, "SIGUSR2", SignalEffect::kIgnored, "kill -USR2"},
    {SIGPIPE, "SIGPIPE", SignalEffect::kIgnored, "the reader of the output has closed it"},
    {SIGALRM, "SIGALRM", SignalEffect::kIgnored, "timer"},
    {SIGTERM, "SIGTERM", SignalEffect::kEnds, "kill, supervisor, shutdown"},
    {SIGSTKFLT, "SIGSTKFLT", SignalEffect::kIgnored, "not used by Linux"},
    {SIGCHLD, "SIGCHLD", SignalEffect::kNoEffect, "a child has ended"},
    {SIGCONT, "SIGCONT", SignalEffect::kNoEffect, "fg, bg: a stopped process continues"},
    {SIGSTOP, "SIGSTOP", SignalEffect::kStops, "kill -STOP"},
    {SIGTSTP, "SIGTSTP", SignalEffect::kIgnored, "Ctrl-Z"},
    {SIGTTIN, "SIGTTIN", SignalEffect::kIgnored, "reads from the terminal in the background"},
    {SIGTTOU, "SIGTTOU", SignalEffect::kIgnored, "writes to the terminal in the background (stty tostop)"},
    {SIGURG, "SIGURG", SignalEffect::kNoEffect, "urgent data of a socket"},
    {SIGXCPU, "SIGXCPU", SignalEffect::kEnds, "CPU time limit reached; SIGKILL follows"},
    {SIGXFSZ, "SIGXFSZ", SignalEffect::kIgnored, "file size limit reached; the write fails"},
    {SIGVTALRM, "SIGVTALRM", SignalEffect::kIgnored, "timer"},
    {SIGPROF, "SIGPROF", SignalEffect::kIgnored, "profiling timer"},
    {SIGWINCH, "SIGWINCH", SignalEffect::kNoEffect, "terminal resized"},
    {SIGIO, "SIGIO", SignalEffect::kIgnored, "input or output is possible"},
    {SIGPWR, "SIGPWR", SignalEffect::kEnds, "power failure"},
    {SIGSYS, "SIGSYS", SignalEffect::kKills, "defect: forbidden system call"},
}};

/// Signals with this effect.
template <SignalEffect kEffect>
consteval auto signalsThat() {
  constexpr auto kHas = [](const SignalRow& row) { return row.effect == kEffect; };
  constexpr std::size_t kCount = [kHas] {
    std::size_t count = 0;
    for (const SignalRow& row : kSignals) count += kHas(row) ? 1 : 0;
    return count;
  }();
  std::array<int, kCount> numbers{};
  std::size_t next = 0;
  for (const SignalRow& row : kSignals)
    if (kHas(row)) numbers[next++] = row.number;
  return numbers;
}
inline constexpr auto kEndSignals = signalsThat<SignalEffect::kEnds>();
inline constexpr auto kIgnoredSignals = signalsThat<SignalEffect::kIgnored>();

/// Call before the first thread: ignores kIgnoredSignals and real-time signals. Child processes inherit this; see
/// restoreIgnoredSignals().
void ignoreSignals();

/// ignoreSignals(), and calls `handler` on kEndSignals. SIGHUP stays ignored if it was ignored before (nohup).
void onEndSignals(void (*handler)(int, siginfo_t*, void*), int flags = 0);

/// ignoreSignals(), and sets endRequested() on kEndSignals.
void endOnSignals();
[[nodiscard]] const std::atomic<bool>& endRequested();

/// ignoreSignals(), and blocks kEndSignals; returns the set for sigtimedwait(). Without SIGHUP if it was ignored before
/// (nohup): sigtimedwait() would return a blocked signal even though it is ignored.
[[nodiscard]] sigset_t blockEndSignals();

/// Between fork and exec: restores the default action of what ignoreSignals() changed. Async-signal-safe.
void restoreIgnoredSignals();

}  // namespace darwinop
