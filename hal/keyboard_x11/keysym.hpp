// X11's names of keys into the codes that controllers know. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "hal/keyboard.hpp"

namespace darwinop::x11 {

/// Nothing: no code for this one, such as for Caps Lock or a letter that ASCII does not have.
[[nodiscard]] std::optional<Key> keyOfKeysym(std::uint32_t keysym);

/// The bit of Shift, Control or Alt; 0: it is none of them.
[[nodiscard]] Key modifierOfKeysym(std::uint32_t keysym);

/// The code of a key that has these keysyms: plain, with Shift, and the same for the next layouts. What it is without
/// Shift counts; a key that is nothing there (an accented letter, a Cyrillic one) is what it is elsewhere. With
/// num_lock the numeric pad gives digits.
[[nodiscard]] std::optional<Key> keyOfKeysyms(std::span<const std::uint32_t> keysyms, bool num_lock);

/// The modifiers among the `state` of an X11 event.
[[nodiscard]] Key modifiersOfState(std::uint16_t state);
[[nodiscard]] bool numLockOfState(std::uint16_t state);

/// For people: "Shift+A", "Up", "Space".
[[nodiscard]] std::string keyName(Key key);

}  // namespace darwinop::x11
