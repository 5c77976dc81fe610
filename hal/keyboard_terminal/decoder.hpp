// Decodes terminal key sequences. Pure: time is an argument.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/keyboard.hpp"

namespace darwinop::terminal {

using Nanos = std::chrono::nanoseconds;

/// Sequences of xterm, the Linux console and rxvt. Unknown sequences are discarded as a whole, so that their bytes are
/// not decoded as letters.
class KeyDecoder {
 public:
  /// A sequence starts with the byte of Escape. If nothing follows for this long, it was the Escape key; over a slow
  /// network the parts of a sequence may be this far apart.
  static constexpr Nanos kEscapeAlone = std::chrono::milliseconds{80};

  /// Keys completed by these bytes; several if they arrived at once.
  std::vector<Key> feed(std::string_view bytes, Nanos now);
  /// The Escape key, if its timeout has passed.
  std::optional<Key> timeOut(Nanos now);

 private:
  enum class State { kPlain, kEscape, kBracket, kLetter };
  std::optional<Key> take(unsigned char byte);
  [[nodiscard]] std::optional<Key> sequence(char last) const;

  State state_ = State::kPlain;
  std::string digits_;  // parameters of the current sequence
  Nanos last_byte_{0};
};

}  // namespace darwinop::terminal
