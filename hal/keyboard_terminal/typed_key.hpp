// Taps and held keys of terminals that report key presses but no releases.
#pragma once

#include <chrono>
#include <optional>

#include "hal/held_keys.hpp"

namespace darwinop::terminal {

/// A tap is a press for one take(). A held key repeats: first after 0.25 s (Linux console), 0.5 s (GNOME) or 0.66 s
/// (plain X11), which looks like a second tap, then every 33 to 100 ms. From the second press within kInterval on it
/// counts as held, for kRepeated after the last one. Only the last key repeats, so another key ends it at once.
class TypedKey {
 public:
  using Nanos = std::chrono::nanoseconds;
  static constexpr Nanos kInterval = std::chrono::milliseconds{120}, kRepeated = std::chrono::milliseconds{200};

  /// `keys` must outlive it.
  explicit TypedKey(HeldKeys& keys) : keys_{keys} {}

  void type(Key key, Nanos now) {
    expire(now);
    const bool repeated = last_ && key == key_ && (until_ || now - *last_ < kInterval);
    if (!repeated) keys_.releaseAll();
    const auto id = static_cast<std::uint32_t>(key);
    keys_.press(id, key & kKeyCodeMask, key & ~kKeyCodeMask);
    if (!repeated) keys_.release(id);
    key_ = key;
    last_ = now;
    until_ = repeated ? std::optional{now + kRepeated} : std::nullopt;
  }

  void expire(Nanos now) {
    if (!until_ || now < *until_) return;
    until_.reset();
    keys_.releaseAll();
  }

 private:
  HeldKeys& keys_;
  Key key_ = 0;
  std::optional<Nanos> last_, until_;  // last press; end of a held key, empty while none is held
};

}  // namespace darwinop::terminal
