// Keyboard input from the controlling terminal.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "hal/held_keys.hpp"
#include "hal/keyboard_terminal/decoder.hpp"
#include "hal/keyboard_terminal/raw_mode.hpp"
#include "hal/keyboard_terminal/typed_key.hpp"

namespace darwinop::terminal {

/// Keys have releases if the terminal can report them (key_report.hpp), else see TypedKey. Created and run by one
/// thread that blocks signals. One per process.
class KeyTerminal {
 public:
  enum class End : std::uint8_t { kStopped, kTerminalGone };

  /// Throws std::runtime_error with the reason if there is no terminal. `keys` must outlive it.
  explicit KeyTerminal(HeldKeys& keys, int fd = 0) : fd_{fd}, raw_{fd}, keys_{keys}, typed_{keys} {}

  /// Returns when `stop_fd` is readable, `ending` is true, or the terminal is closed; no key is held then. `ending` is
  /// polled every 50 ms: after the first Ctrl-C the terminal must be restored, since the second one kills the program.
  End run(int stop_fd, const std::atomic<bool>& ending);

 private:
  /// Without a reply while a key is held, all keys count as released: a lost connection reports no release.
  static constexpr Nanos kSilence = std::chrono::seconds{1};
  /// Between two queries: a terminal that replies at once would be asked as fast as it can.
  static constexpr Nanos kQuestions = std::chrono::milliseconds{100};

  [[nodiscard]] bool readAll();
  void handle(const KeyEvent& event, Nanos now);
  void watchForSilence(Nanos now);

  int fd_;
  RawMode raw_;
  HeldKeys& keys_;
  TypedKey typed_;
  KeyDecoder decoder_;
  bool has_reports_ = false;
  std::optional<Nanos> asked_at_;  // query without a reply yet
  Nanos next_question_{0};
};

}  // namespace darwinop::terminal
