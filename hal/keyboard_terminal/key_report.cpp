#include "hal/keyboard_terminal/key_report.hpp"

#include <array>
#include <charconv>

namespace darwinop::terminal {
namespace {

// Functional key codes of the protocol, from Unicode's private area.
constexpr int kPad0 = 57399, kPad9 = 57408, kPadDecimal = 57409, kPadBegin = 57427;
constexpr std::array<Key, kPadBegin - kPadDecimal + 1> kPadKeys{'.',
                                                                '/',
                                                                '*',
                                                                '-',
                                                                '+',
                                                                kKeyEnter,
                                                                '=',
                                                                ',',
                                                                kKeyNumpadLeft,
                                                                kKeyNumpadRight,
                                                                kKeyNumpadUp,
                                                                kKeyNumpadDown,
                                                                kKeyNumpadPageUp,
                                                                kKeyNumpadPageDown,
                                                                kKeyNumpadHome,
                                                                kKeyNumpadEnd,
                                                                kKeyNumpadInsert,
                                                                kKeyNumpadDelete,
                                                                kKeyNumpadBegin};
constexpr int kLeftShift = 57441, kRightMeta = 57452;
constexpr int kReleaseEvent = 3;

/// The text before `separator`, which is removed from `rest` with it.
std::string_view nextField(std::string_view& rest, char separator) {
  const std::size_t length = rest.find(separator);
  const std::string_view field = rest.substr(0, length);
  rest.remove_prefix(length == std::string_view::npos ? rest.size() : length + 1);
  return field;
}

/// 0 if absent.
int numberOf(std::string_view digits) {
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

std::optional<Key> keyOfCode(int code) {
  switch (code) {
    case '\t':
      return kKeyTab;
    case '\r':
      return kKeyEnter;
    case kKeyEscape:
      return kKeyEscape;
    case 127:
      return kKeyBackspace;
    default:
      break;
  }
  if (code >= 'a' && code <= 'z') return code - 'a' + 'A';
  if (code >= ' ' && code < 127) return code;
  if (code >= kPad0 && code <= kPad9) return code - kPad0 + '0';
  if (code >= kPadDecimal && code <= kPadBegin) return kPadKeys[static_cast<std::size_t>(code - kPadDecimal)];
  return std::nullopt;
}

}  // namespace

KeyState keyStateOf(std::string_view parameter) {
  const int modifiers = numberOf(nextField(parameter, ':'));
  const unsigned bits = modifiers > 0 ? static_cast<unsigned>(modifiers) - 1 : 0;
  return {.modifiers = ((bits & 1U) != 0 ? kKeyShift : 0) | ((bits & 2U) != 0 ? kKeyAlt : 0) |
                       ((bits & 4U) != 0 ? kKeyControl : 0),
          .released = numberOf(parameter) == kReleaseEvent};
}

std::optional<KeyEvent> keyOfReport(std::string_view parameters) {
  std::string_view codes = nextField(parameters, ';');
  const KeyState state = keyStateOf(nextField(parameters, ';'));
  const int code = numberOf(nextField(codes, ':'));
  (void)nextField(codes, ':');  // shifted: letters are capitals anyway, and others are as in the window
  if (code >= kLeftShift && code <= kRightMeta) return KeyEvent{KeyEvent::Kind::kModifiers, state.modifiers};
  std::optional<Key> key = keyOfCode(code);
  if (!key) key = keyOfCode(numberOf(codes));  // another alphabet: the key of the base layout
  if (!key) return std::nullopt;
  return KeyEvent{state.released ? KeyEvent::Kind::kReleased : KeyEvent::Kind::kPressed, *key | state.modifiers,
                  static_cast<std::uint32_t>(*key)};
}

}  // namespace darwinop::terminal
