#include "hal/keyboard_x11/keysym.hpp"

#include <X11/keysym.h>

#include <array>

namespace darwinop::x11 {
namespace {

struct Row {
  std::uint32_t keysym;
  Key key;
  const char* name;
};

// First column: X11/keysymdef.h.
constexpr std::array kRows{
    Row{XK_space, ' ', "Space"},
    Row{XK_BackSpace, kKeyBackspace, "Backspace"},
    Row{XK_Tab, kKeyTab, "Tab"},
    Row{XK_ISO_Left_Tab, kKeyTab, "Tab"},
    Row{XK_Return, kKeyEnter, "Enter"},
    Row{XK_KP_Enter, kKeyEnter, "Enter"},
    Row{XK_Escape, kKeyEscape, "Escape"},
    Row{XK_Delete, kKeyDelete, "Delete"},
    Row{XK_Insert, kKeyInsert, "Insert"},
    Row{XK_Home, kKeyHome, "Home"},
    Row{XK_End, kKeyEnd, "End"},
    Row{XK_Left, kKeyLeft, "Left"},
    Row{XK_Up, kKeyUp, "Up"},
    Row{XK_Right, kKeyRight, "Right"},
    Row{XK_Down, kKeyDown, "Down"},
    Row{XK_Page_Up, kKeyPageUp, "Page Up"},
    Row{XK_Page_Down, kKeyPageDown, "Page Down"},
    Row{XK_KP_Home, kKeyNumpadHome, "Numpad Home"},
    Row{XK_KP_End, kKeyNumpadEnd, "Numpad End"},
    Row{XK_KP_Left, kKeyNumpadLeft, "Numpad Left"},
    Row{XK_KP_Up, kKeyNumpadUp, "Numpad Up"},
    Row{XK_KP_Right, kKeyNumpadRight, "Numpad Right"},
    Row{XK_KP_Down, kKeyNumpadDown, "Numpad Down"},
    Row{XK_KP_Page_Up, kKeyNumpadPageUp, "Numpad Page Up"},
    Row{XK_KP_Page_Down, kKeyNumpadPageDown, "Numpad Page Down"},
    Row{XK_KP_Begin, kKeyNumpadBegin, "Numpad 5"},
    Row{XK_KP_Insert, kKeyNumpadInsert, "Numpad Insert"},
    Row{XK_KP_Delete, kKeyNumpadDelete, "Numpad Delete"},
};

constexpr bool isNumpadDigit(std::uint32_t keysym) {
  return keysym >= XK_KP_0 && keysym <= XK_KP_9;
}
/// * + , - . / 0..9 of the numeric pad are in ASCII order.
constexpr bool isNumpadCharacter(std::uint32_t keysym) {
  return keysym >= XK_KP_Multiply && keysym <= XK_KP_9;
}

}  // namespace

std::optional<Key> keyOfKeysym(std::uint32_t keysym) {
  for (const Row& row : kRows)
    if (row.keysym == keysym) return row.key;
  if (keysym >= XK_a && keysym <= XK_z) return static_cast<Key>(keysym - XK_a + 'A');
  if (keysym > XK_space && keysym <= XK_asciitilde) return static_cast<Key>(keysym);
  if (keysym >= XK_F1 && keysym <= XK_F12) return kKeyF1 + static_cast<Key>(keysym - XK_F1);
  if (isNumpadCharacter(keysym)) return static_cast<Key>(keysym - XK_KP_Multiply + '*');
  return std::nullopt;
}

Key modifierOfKeysym(std::uint32_t keysym) {
  switch (keysym) {
    case XK_Shift_L:
    case XK_Shift_R:
      return kKeyShift;
    case XK_Control_L:
    case XK_Control_R:
      return kKeyControl;
    case XK_Alt_L:
    case XK_Alt_R:
      return kKeyAlt;
    default:
      return 0;
  }
}

std::optional<Key> keyOfKeysyms(std::span<const std::uint32_t> keysyms, bool num_lock) {
  if (num_lock && keysyms.size() > 1 && (isNumpadDigit(keysyms[1]) || keysyms[1] == XK_KP_Decimal))
    return keyOfKeysym(keysyms[1]);
  for (const std::uint32_t keysym : keysyms)
    if (const auto key = keyOfKeysym(keysym)) return key;
  return std::nullopt;
}

Key modifiersOfState(std::uint16_t state) {
  // Modifier bits of the X11 protocol: Shift, Control, and Mod1, which is usually Alt.
  constexpr unsigned kShiftBit = 1U << 0U, kControlBit = 1U << 2U, kMod1Bit = 1U << 3U;
  return ((state & kShiftBit) != 0 ? kKeyShift : 0) | ((state & kControlBit) != 0 ? kKeyControl : 0) |
         ((state & kMod1Bit) != 0 ? kKeyAlt : 0);
}

bool numLockOfState(std::uint16_t state) {
  constexpr unsigned kMod2Bit = 1U << 4U;  // usually Num Lock
  return (state & kMod2Bit) != 0;
}

std::string keyName(Key key) {
  std::string name;
  if ((key & kKeyControl) != 0) name += "Control+";
  if ((key & kKeyAlt) != 0) name += "Alt+";
  if ((key & kKeyShift) != 0) name += "Shift+";
  const Key code = key & kKeyCodeMask;
  for (const Row& row : kRows)
    if (row.key == code) return name + row.name;
  if (code >= kKeyF1 && code <= kKeyF12) return name + "F" + std::to_string(code - kKeyF1 + 1);
  return name + static_cast<char>(code);
}

}  // namespace darwinop::x11
