// A terminal that hands over every key at once and shows none of them; as before when this ends.
#pragma once

namespace darwinop::terminal {

/// One at a time in a process. Ctrl-C and Ctrl-\ stay what they are; Ctrl-Z is a key: a controller that hosts the
/// robot's loop must not be stopped. A program that crashes (SIGSEGV, SIGABRT and their kind) leaves the terminal as it
/// was, too; one that is killed with kill -9 cannot: `stty sane` helps.
class RawMode {
 public:
  /// Throws std::runtime_error: `fd` is no terminal, or this program runs in its background, and is not to read from
  /// it.
  explicit RawMode(int fd);
  ~RawMode();
  RawMode(const RawMode&) = delete;
  RawMode& operator=(const RawMode&) = delete;
};

}  // namespace darwinop::terminal
