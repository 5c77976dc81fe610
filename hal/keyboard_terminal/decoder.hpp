// Decodes terminal key sequences. Pure: time is an argument.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/keyboard_terminal/key_event.hpp"

namespace darwinop::terminal {

using Nanos = std::chrono::nanoseconds;

/// Sequences of xterm, the Linux console and rxvt. Unknown sequences are discarded as a whole, so that their bytes are
/// not decoded as letters. With key reports (key_report.hpp), once the terminal has said so, keys have releases.
class KeyDecoder {
 public:
  /// A sequence starts with the byte of Escape. If nothing follows for this long, it was the Escape key; over a slow
  /// network the parts of a sequence may be this far apart.
  static constexpr Nanos kEscapeAlone = std::chrono::milliseconds{80};

  /// Events completed by these bytes; several if they arrived at once.
  std::vector<KeyEvent> feed(std::string_view bytes, Nanos now);
  /// The Escape key, if its timeout has passed.
  std::optional<KeyEvent> timeOut(Nanos now);

 private:
  enum class State { kPlain, kEscape, kBracket, kLetter };
  std::optional<KeyEvent> take(unsigned char byte);
  [[nodiscard]] std::optional<KeyEvent> sequence(char last);
  [[nodiscard]] std::optional<KeyEvent> withKnownReleases(std::optional<KeyEvent> event) const;
  [[nodiscard]] std::optional<KeyEvent> reply(char last);

  State state_ = State::kPlain;
  std::string digits_;  // parameters of the current sequence
  Nanos last_byte_{0};
  bool has_releases_ = false;  // by the last reply to kAskForReports
};

}  // namespace darwinop::terminal
