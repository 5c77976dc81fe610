// Terminal in raw mode without echo; restored by the destructor.
#pragma once

namespace darwinop::terminal {

inline constexpr const char* kInputNotATerminal = "standard input is not a terminal";

/// One per process. Ctrl-C and Ctrl-\ keep their meaning; Ctrl-Z is a key: a controller that hosts the robot's loop
/// must not be stopped. A crash (SIGSEGV, SIGABRT and others) also restores the terminal; kill -9 cannot: run `stty
/// sane`.
class RawMode {
 public:
  /// Throws std::runtime_error if `fd` is not a terminal, or if this program runs in its background.
  explicit RawMode(int fd);
  ~RawMode();
  RawMode(const RawMode&) = delete;
  RawMode& operator=(const RawMode&) = delete;
};

}  // namespace darwinop::terminal
