// The one way to start a program as a child process.
#pragma once

#include <signal.h>
#include <sys/types.h>

#include <array>
#include <chrono>
#include <optional>

#include "hal/process/ending.hpp"
#include "hal/process/start.hpp"

namespace darwinop::process {

/// Blocks all signals of this thread while it lives.
class SignalsHeld {
 public:
  SignalsHeld();
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t before_;
};

/// First words of the exception, before the program's name and the reason.
inline constexpr const char* kCannotStart = "cannot start ";

/// Not thread-safe.
class ChildProcess {
 public:
  /// Throws std::system_error "cannot start NAME: reason". Without `error_prefix` it returns after exec and does not
  /// copy page tables (vfork), so that a real-time loop of this process is not delayed.
  explicit ChildProcess(const Start& start);
  /// Closes our ends of its pipes. Sends SIGTERM if it still runs, without waiting.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }
  /// Our end of the pipe of its descriptor `number`; -1: it has none.
  [[nodiscard]] int stream(std::size_t number) const { return streams_.at(number); }
  void closeStream(std::size_t number);

  /// How it ended; empty: it still runs. Never blocks. SIGKILL if somebody else has reaped it.
  [[nodiscard]] std::optional<Ending> ended();
  Ending wait();
  std::optional<Ending> waitFor(std::chrono::milliseconds at_most);
  /// To the process only; no effect after its end.
  void signal(int number);
  /// To its process group; to the process if it does not lead one yet. No effect after its end.
  void signalGroup(int number);
  /// SIGKILL to what the process has started in its group and has left behind; no effect before its end.
  void killRemaining();
  /// Waits; after `grace` kills the process, not its group.
  Ending waitOrKill(std::chrono::milliseconds grace);
  /// Lets it run on: it is neither ended nor reaped by us.
  void detach();

 private:
  bool reap(int options);

  pid_t pid_ = 0;
  std::array<int, Start::kMaxStreams> streams_{-1, -1, -1, -1};
  std::optional<Ending> ending_;
};

}  // namespace darwinop::process
