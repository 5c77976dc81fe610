// What a terminal reports about keys.
#pragma once

#include <cstdint>

#include "hal/keyboard.hpp"

namespace darwinop::terminal {

struct KeyEvent {
  enum class Kind : std::uint8_t {
    kTyped,      // pressed or repeating; this terminal reports no release
    kPressed,    // pressed or repeating; kReleased follows
    kReleased,   //
    kModifiers,  // a modifier key was pressed or released; `key` has the held modifiers
    kFocusLost,  // releases are not reported any more
    kReports     // reply to kAskForReports; `key` has the flags
  };
  Kind kind = Kind::kTyped;
  Key key = 0;
  std::uint32_t id = 0;  // of the physical key: its code without modifiers

  bool operator==(const KeyEvent&) const = default;
};

}  // namespace darwinop::terminal
