// Maps X11 keysyms to key codes. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hal/keyboard.hpp"

namespace darwinop::x11 {

/// Empty: no code, for example Caps Lock or a letter outside ASCII.
[[nodiscard]] std::optional<Key> keyOfKeysym(std::uint32_t keysym);

/// The bit of Shift, Control or Alt; 0: not a modifier.
[[nodiscard]] Key modifierOfKeysym(std::uint32_t keysym);

/// Code of a key with these keysyms: unshifted, shifted, then the same for further layouts. The unshifted keysym
/// counts; if it has no code (an accented or Cyrillic letter), the next layout is used. num_lock: the numeric pad gives
/// digits.
[[nodiscard]] std::optional<Key> keyOfKeysyms(std::span<const std::uint32_t> keysyms, bool num_lock);

/// Modifiers in the `state` of an X11 event.
[[nodiscard]] Key modifiersOfState(std::uint16_t state);
[[nodiscard]] bool numLockOfState(std::uint16_t state);

/// Display name: "Shift+A", "Up", "Space".
[[nodiscard]] std::string keyName(Key key);

}  // namespace darwinop::x11
