// Terminal in raw mode without echo; restored by the destructor.
#pragma once

#include "hal/keyboard.hpp"

namespace darwinop::terminal {

inline constexpr const char* kInputNotATerminal = "standard input is not a terminal";

/// One per process. Ctrl-C and Ctrl-\ keep their meaning; Ctrl-Z is a key: a controller that hosts the robot's loop
/// must not be stopped. Key reports (key_report.hpp) end with raw mode. A crash (SIGSEGV, SIGABRT and others) also
/// restores the terminal; kill -9 cannot: run `reset`.
class RawMode {
 public:
  /// Throws std::runtime_error if `fd` is not a terminal, or if this program runs in its background.
  explicit RawMode(int fd);
  ~RawMode();
  RawMode(const RawMode&) = delete;
  RawMode& operator=(const RawMode&) = delete;

  /// Sends kAskForReports; never waits.
  void askForReports() noexcept;
  /// Once: starts key reports, and asks for the flags. False: they had been started.
  bool startReports();
  /// SIGINT or SIGQUIT for the keys that raise them, since the terminal does not while it reports keys; else 0.
  [[nodiscard]] static int signalOf(Key key) noexcept;

 private:
  int fd_;
};

}  // namespace darwinop::terminal
