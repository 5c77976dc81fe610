// The bytes that a terminal sends for its keys. Pure: time comes as an argument.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hal/keyboard.hpp"

namespace darwinop::terminal {

using Nanos = std::chrono::nanoseconds;

/// Sequences of xterm, of the Linux console and of rxvt. What they mean nothing by is swallowed whole: the rest of an
/// unknown sequence is not taken for letters.
class KeyDecoder {
 public:
  /// A sequence begins with the byte of Escape. When nothing follows for this long, it was the key; over a slow network
  /// the parts of a sequence may come this far apart.
  static constexpr Nanos kEscapeAlone = std::chrono::milliseconds{80};

  /// The keys that these bytes end; several, when they came at once.
  std::vector<Key> feed(std::string_view bytes, Nanos now);
  /// The Escape key, when it is that.
  std::optional<Key> settle(Nanos now);

 private:
  enum class State { kPlain, kEscape, kBracket, kLetter };
  std::optional<Key> take(unsigned char byte);
  [[nodiscard]] std::optional<Key> sequence(char last) const;

  State state_ = State::kPlain;
  std::string digits_;  // of the sequence under way
  Nanos last_byte_{0};
};

}  // namespace darwinop::terminal
