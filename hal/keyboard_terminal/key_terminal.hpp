// Keyboard input from the controlling terminal.
#pragma once

#include <atomic>
#include <cstdint>

#include "hal/held_keys.hpp"
#include "hal/keyboard_terminal/decoder.hpp"
#include "hal/keyboard_terminal/raw_mode.hpp"
#include "hal/keyboard_terminal/typed_key.hpp"

namespace darwinop::terminal {

/// Created and run by one thread that blocks signals. One per process.
class KeyTerminal {
 public:
  enum class End : std::uint8_t { kStopped, kTerminalGone };

  /// Throws std::runtime_error with the reason if there is no terminal. `keys` must outlive it.
  explicit KeyTerminal(HeldKeys& keys, int fd = 0) : fd_{fd}, raw_{fd}, keys_{keys}, typed_{keys} {}

  /// Returns when `stop_fd` is readable, `ending` is true, or the terminal is closed; no key is held then. `ending` is
  /// polled every 50 ms: after the first Ctrl-C the terminal must be restored, since the second one kills the program.
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
