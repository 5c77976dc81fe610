// Effect of each signal on programs that drive or observe a robot. docs/threads.md describes it for users.
#pragma once

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace darwinop {

enum class SignalEffect {
  kEnds,      // normal end: the robot comes to rest first
  kIgnored,   // ignored; the default action would end or stop the process
  kNoEffect,  // default action, which is to ignore
  kKills,     // ends the process at once: a defect of the program, or kill -9. The supervisor's rescue takes over
  kStops,     // cannot be caught; stops the process. The supervisor's rescue takes over
};

struct SignalRow {
  int number;
  std::string_view name;
  SignalEffect effect;
  std::string_view cause = {};  // for signals with an effect
};

/// The 31 signals of Linux on x86.
inline constexpr std::array<SignalRow, 31> kSignals{{
    {SIGHUP, "SIGHUP", SignalEffect::kEnds, "terminal or ssh session gone; ignored under nohup"},
    {SIGINT, "SIGINT", SignalEffect::kEnds, "Ctrl-C"},
    {SIGQUIT, "SIGQUIT", SignalEffect::kEnds, "Ctrl-\\"},
    {SIGILL, "SIGILL", SignalEffect::kKills, "defect: illegal instruction"},
    {SIGTRAP, "SIGTRAP", SignalEffect::kKills, "breakpoint without a debugger"},
    {SIGABRT, "SIGABRT", SignalEffect::kKills, "defect: assert, uncaught exception"},
    {SIGBUS, "SIGBUS", SignalEffect::kKills, "defect; a truncated shared file is survived"},
    {SIGFPE, "SIGFPE", SignalEffect::kKills, "defect: integer division by zero"},
    {SIGKILL, "SIGKILL", SignalEffect::kKills, "kill -9, out of memory"},
    {SIGUSR1, "SIGUSR1", SignalEffect::kIgnored},
    {SIGSEGV, "SIGSEGV", SignalEffect::kKills, "defect: invalid address"},
    {SIGUSR2, "SIGUSR2", SignalEffect::kIgnored},
    {SIGPIPE, "SIGPIPE", SignalEffect::kIgnored},
    {SIGALRM, "SIGALRM", SignalEffect::kIgnored},
    {SIGTERM, "SIGTERM", SignalEffect::kEnds, "kill, supervisor, shutdown"},
    {SIGSTKFLT, "SIGSTKFLT", SignalEffect::kIgnored},
    {SIGCHLD, "SIGCHLD", SignalEffect::kNoEffect},
    {SIGCONT, "SIGCONT", SignalEffect::kNoEffect},
    {SIGSTOP, "SIGSTOP", SignalEffect::kStops, "kill -STOP"},
    {SIGTSTP, "SIGTSTP", SignalEffect::kIgnored},
    {SIGTTIN, "SIGTTIN", SignalEffect::kIgnored},
    {SIGTTOU, "SIGTTOU", SignalEffect::kIgnored},
    {SIGURG, "SIGURG", SignalEffect::kNoEffect},
    {SIGXCPU, "SIGXCPU", SignalEffect::kEnds, "CPU time limit; SIGKILL follows"},
    {SIGXFSZ, "SIGXFSZ", SignalEffect::kIgnored},
    {SIGVTALRM, "SIGVTALRM", SignalEffect::kIgnored},
    {SIGPROF, "SIGPROF", SignalEffect::kIgnored},
    {SIGWINCH, "SIGWINCH", SignalEffect::kNoEffect},
    {SIGIO, "SIGIO", SignalEffect::kIgnored},
    {SIGPWR, "SIGPWR", SignalEffect::kEnds, "power failure"},
    {SIGSYS, "SIGSYS", SignalEffect::kKills, "defect: forbidden system call"},
}};

/// Numbers of the signals with this effect.
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

/// Ignores kIgnoredSignals and the real-time signals. Call before the first thread. process::ChildProcess restores the
/// defaults for programs that it starts.
void ignoreSignals();

/// ignoreSignals(), and `handler` for kEndSignals; not for SIGHUP if it was ignored before (nohup).
void onEndSignals(void (*handler)(int, siginfo_t*, void*), int flags = 0);

/// ignoreSignals(), and kEndSignals set endRequested().
void endOnSignals();
[[nodiscard]] const std::atomic<bool>& endRequested();

/// ignoreSignals(), and blocks kEndSignals; returns the set for sigtimedwait(). SIGHUP is not in it if it was ignored
/// before (nohup): sigtimedwait() would return a blocked signal although it is ignored.
[[nodiscard]] sigset_t blockEndSignals();

}  // namespace darwinop
