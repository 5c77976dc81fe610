// Keys from the terminal that the program was started in.
#pragma once

#include <atomic>
#include <cstdint>

#include "hal/held_keys.hpp"
#include "hal/keyboard_terminal/decoder.hpp"
#include "hal/keyboard_terminal/raw_mode.hpp"
#include "hal/keyboard_terminal/typed_key.hpp"

namespace darwinop::terminal {

/// Made and run by one thread that blocks signals. One at a time in a process.
class KeyTerminal {
 public:
  enum class End : std::uint8_t { kStopped, kTerminalGone };

  /// Throws std::runtime_error: there is no terminal, and why. `keys` must outlive it.
  explicit KeyTerminal(HeldKeys& keys, int fd = 0) : fd_{fd}, raw_{fd}, keys_{keys}, typed_{keys} {}

  /// Until `stop_fd` can be read, `ending` is true, or the terminal goes away. No key is held then. `ending` is looked
  /// at every 50 ms: after the first Ctrl-C the terminal has to be as before, since the second one kills the program.
  End run(int stop_fd, const std::atomic<bool>& ending);

 private:
  [[nodiscard]] bool readAll();

  int fd_;
  RawMode raw_;
  HeldKeys& keys_;
  TypedKey typed_;
  KeyDecoder decoder_;
};

}  // namespace darwinop::terminal
