// Key hold time for terminals, which report key presses but no releases.
#pragma once

#include <chrono>
#include <optional>

#include "hal/held_keys.hpp"

namespace darwinop::terminal {

/// A held key repeats after 0.25 s (Linux console), 0.5 s (GNOME) or 0.66 s (plain X11), then every 33 to 100 ms.
/// Hold time: 0.7 s after the first press, to cover the initial delay, and 0.2 s after each repetition. Only the last
/// key repeats, so another key ends it at once.
class TypedKey {
 public:
  using Nanos = std::chrono::nanoseconds;
  static constexpr Nanos kFirst = std::chrono::milliseconds{700}, kRepeated = std::chrono::milliseconds{200};

  /// `keys` must outlive it.
  explicit TypedKey(HeldKeys& keys) : keys_{keys} {}

  void type(Key key, Nanos now) {
    expire(now);
    const bool repeated = until_ && key == key_;
    if (!repeated) keys_.releaseAll();
    keys_.press(static_cast<std::uint32_t>(key), key & kKeyCodeMask, key & ~kKeyCodeMask);
    key_ = key;
    until_ = now + (repeated ? kRepeated : kFirst);
  }

  void expire(Nanos now) {
    if (!until_ || now < *until_) return;
    until_.reset();
    keys_.releaseAll();
  }

 private:
  HeldKeys& keys_;
  Key key_ = 0;
  std::optional<Nanos> until_;
};

}  // namespace darwinop::terminal
