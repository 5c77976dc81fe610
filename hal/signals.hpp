// What each signal does to a program that drives or watches a robot. docs/threads.md has the table for people.
#pragma once

#include <signal.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <string_view>

namespace darwinop {

enum class SignalEffect {
  kEnds,      // ends tidily: the robot comes to rest first
  kIgnored,   // has no effect, where its default would end or stop the process
  kNoEffect,  // the default, which changes nothing
  kKills,     // ends the process at once: a defect of the program, or kill -9. The supervisor's rescue takes over
  kStops,     // cannot be caught: the process stands still. The supervisor's rescue takes over
};

struct SignalRow {
  int number;
  std::string_view name;
  SignalEffect effect;
  std::string_view comes_when;
};

/// The 31 signals of Linux on x86.
inline constexpr std::array<SignalRow, 31> kSignals{{
    {SIGHUP, "SIGHUP", SignalEffect::kEnds, "terminal or ssh session is gone; ignored when started by nohup"},
    {SIGINT, "SIGINT", SignalEffect::kEnds, "Ctrl-C"},
    {SIGQUIT, "SIGQUIT", SignalEffect::kEnds, "Ctrl-\\"},
    {SIGILL, "SIGILL", SignalEffect::kKills, "defect: instruction unknown to this processor"},
    {SIGTRAP, "SIGTRAP", SignalEffect::kKills, "breakpoint without a debugger"},
    {SIGABRT, "SIGABRT", SignalEffect::kKills, "defect: assert, uncaught exception"},
    {SIGBUS, "SIGBUS", SignalEffect::kKills, "defect; a shared file that was shortened is survived"},
    {SIGFPE, "SIGFPE", SignalEffect::kKills, "defect: division of an integer by zero"},
    {SIGKILL, "SIGKILL", SignalEffect::kKills, "kill -9, or no memory is left"},
    {SIGUSR1, "SIGUSR1", SignalEffect::kIgnored, "kill -USR1"},
    {SIGSEGV, "SIGSEGV", SignalEffect::kKills, "defect: access to memory that is not there"},
    {SIGUSR2, "SIGUSR2", SignalEffect::kIgnored, "kill -USR2"},
    {SIGPIPE, "SIGPIPE", SignalEffect::kIgnored, "nobody reads the output any more"},
    {SIGALRM, "SIGALRM", SignalEffect::kIgnored, "timer"},
    {SIGTERM, "SIGTERM", SignalEffect::kEnds, "kill, supervisor, shutdown"},
    {SIGSTKFLT, "SIGSTKFLT", SignalEffect::kIgnored, "not used by Linux"},
    {SIGCHLD, "SIGCHLD", SignalEffect::kNoEffect, "a child has ended"},
    {SIGCONT, "SIGCONT", SignalEffect::kNoEffect, "fg, bg: a stopped process goes on"},
    {SIGSTOP, "SIGSTOP", SignalEffect::kStops, "kill -STOP"},
    {SIGTSTP, "SIGTSTP", SignalEffect::kIgnored, "Ctrl-Z"},
    {SIGTTIN, "SIGTTIN", SignalEffect::kIgnored, "reads from the terminal in the background"},
    {SIGTTOU, "SIGTTOU", SignalEffect::kIgnored, "writes to the terminal in the background (stty tostop)"},
    {SIGURG, "SIGURG", SignalEffect::kNoEffect, "urgent data of a socket"},
    {SIGXCPU, "SIGXCPU", SignalEffect::kEnds, "limit of CPU time reached; SIGKILL follows"},
    {SIGXFSZ, "SIGXFSZ", SignalEffect::kIgnored, "limit of file size reached; the write fails"},
    {SIGVTALRM, "SIGVTALRM", SignalEffect::kIgnored, "timer"},
    {SIGPROF, "SIGPROF", SignalEffect::kIgnored, "timer of a profiler"},
    {SIGWINCH, "SIGWINCH", SignalEffect::kNoEffect, "terminal has another size"},
    {SIGIO, "SIGIO", SignalEffect::kIgnored, "input or output is possible"},
    {SIGPWR, "SIGPWR", SignalEffect::kEnds, "power fails"},
    {SIGSYS, "SIGSYS", SignalEffect::kKills, "defect: system call that is not allowed"},
}};

/// Those with one effect.
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

/// For programs of this project, before their first thread: signals of kIgnoredSignals and real-time signals have no
/// effect. Programs that are started inherit this: see restoreIgnoredSignals().
void ignoreSignals();

/// ignoreSignals(), and the signals of kEndSignals call `handler`. SIGHUP does not when it was ignored before (nohup).
void onEndSignals(void (*handler)(int, siginfo_t*, void*), int flags = 0);

/// ignoreSignals(), and the signals of kEndSignals set endRequested().
void endOnSignals();
[[nodiscard]] const std::atomic<bool>& endRequested();

/// ignoreSignals(), and the signals of kEndSignals are blocked: the returned set is for sigtimedwait(). SIGHUP is not
/// in it when it was ignored before (nohup): a blocked signal would be waited for although it is ignored.
[[nodiscard]] sigset_t blockEndSignals();

/// In a child between fork and exec: what ignoreSignals() changed is the default again. Async-signal-safe.
void restoreIgnoredSignals();

}  // namespace darwinop
