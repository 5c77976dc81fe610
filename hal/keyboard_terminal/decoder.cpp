#include "hal/keyboard_terminal/decoder.hpp"

#include <charconv>

#include "hal/keyboard_terminal/key_report.hpp"

namespace darwinop::terminal {
namespace {

constexpr unsigned char kEscapeByte = 27, kDeleteByte = 127;

std::optional<Key> ofCharacter(unsigned char byte) {
  if (byte == 0) return kKeyControl | ' ';
  if (byte == '\r' || byte == '\n') return kKeyEnter;
  if (byte == '\t') return kKeyTab;
  if (byte == kDeleteByte || byte == '\b') return kKeyBackspace;
  if (byte < kEscapeByte) return kKeyControl | (byte + 'A' - 1);
  if (byte >= 'a' && byte <= 'z') return byte - 'a' + 'A';
  // Caps Lock looks the same. For other characters Shift depends on the layout and is unknown.
  if (byte >= 'A' && byte <= 'Z') return kKeyShift | byte;
  if (byte >= ' ' && byte < kDeleteByte) return byte;
  return std::nullopt;  // part of a non-ASCII character
}

/// ESC [ ... letter, ESC O letter.
std::optional<Key> ofLetter(char letter) {
  switch (letter) {
    case 'A':
      return kKeyUp;
    case 'B':
      return kKeyDown;
    case 'C':
      return kKeyRight;
    case 'D':
      return kKeyLeft;
    case 'E':
      return kKeyNumpadBegin;
    case 'F':
      return kKeyEnd;
    case 'H':
      return kKeyHome;
    case 'P':
    case 'Q':
    case 'R':
    case 'S':
      return kKeyF1 + (letter - 'P');
    case 'M':
      return kKeyEnter;
    case 'Z':
      return kKeyShift | kKeyTab;
    default:
      return std::nullopt;
  }
}

/// ESC [ number ~; numbers of the VT220; 7 and 8 of rxvt.
std::optional<Key> ofNumber(int number) {
  switch (number) {
    case 1:
    case 7:
      return kKeyHome;
    case 2:
      return kKeyInsert;
    case 3:
      return kKeyDelete;
    case 4:
    case 8:
      return kKeyEnd;
    case 5:
      return kKeyPageUp;
    case 6:
      return kKeyPageDown;
    default:
      break;
  }
  if (number >= 11 && number <= 15) return kKeyF1 + number - 11;
  if (number >= 17 && number <= 21) return kKeyF1 + number - 12;
  if (number >= 23 && number <= 24) return kKeyF1 + number - 13;
  return std::nullopt;
}

int firstNumber(std::string_view digits) {
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

KeyEvent typed(Key key) {
  return {KeyEvent::Kind::kTyped, key, static_cast<std::uint32_t>(key & kKeyCodeMask)};
}

}  // namespace

std::vector<KeyEvent> KeyDecoder::feed(std::string_view bytes, Nanos now) {
  std::vector<KeyEvent> events;
  if (const auto alone = timeOut(now)) events.push_back(*alone);
  for (const char byte : bytes)
    if (const auto event = take(static_cast<unsigned char>(byte))) events.push_back(*event);
  last_byte_ = now;
  return events;
}

std::optional<KeyEvent> KeyDecoder::timeOut(Nanos now) {
  if (state_ == State::kPlain || now < last_byte_ + kEscapeAlone) return std::nullopt;
  const State was = state_;
  state_ = State::kPlain;
  if (was != State::kEscape) return std::nullopt;  // a truncated sequence
  return typed(kKeyEscape);
}

std::optional<KeyEvent> KeyDecoder::take(unsigned char byte) {
  constexpr std::size_t kLongest = 32;
  if (byte == kEscapeByte) {
    const bool twice = state_ == State::kEscape;
    state_ = State::kEscape;
    if (twice) return typed(kKeyEscape);  // pressed twice, or repeating
    return std::nullopt;
  }
  switch (state_) {
    case State::kPlain:
      break;
    case State::kEscape:
      digits_.clear();
      state_ = byte == '[' ? State::kBracket : byte == 'O' ? State::kLetter : State::kPlain;
      if (state_ != State::kPlain) return std::nullopt;
      if (const auto key = ofCharacter(byte)) return typed(kKeyAlt | *key);
      return std::nullopt;
    case State::kBracket:
    case State::kLetter:
      // The Linux console: ESC [ [ A is F1.
      if (byte == '[' && digits_.empty() && state_ == State::kBracket) {
        digits_ += static_cast<char>(byte);
        return std::nullopt;
      }
      if (byte < '@') {
        if (digits_.size() <= kLongest) digits_ += static_cast<char>(byte);  // one more than fits: too long
        return std::nullopt;
      }
      state_ = State::kPlain;
      if (digits_.size() > kLongest) return std::nullopt;
      return sequence(static_cast<char>(byte));
  }
  if (const auto key = ofCharacter(byte)) return typed(*key);
  return std::nullopt;
}

std::optional<KeyEvent> KeyDecoder::sequence(char last) {
  if (digits_ == "[") {
    if (last >= 'A' && last <= 'E') return typed(kKeyF1 + (last - 'A'));
    return std::nullopt;
  }
  if (digits_.starts_with('?')) return reply(last);
  if (digits_.empty() && last == 'O') return KeyEvent{KeyEvent::Kind::kFocusLost};
  if (last == 'u') return withKnownReleases(keyOfReport(digits_));
  const auto semicolon = digits_.find(';');
  const KeyState state =
      semicolon == std::string::npos ? KeyState{} : keyStateOf(std::string_view{digits_}.substr(semicolon + 1));
  const auto key = last == '~' ? ofNumber(firstNumber(digits_)) : ofLetter(last);
  if (!key) return std::nullopt;
  KeyEvent event = typed(*key);
  event.key |= state.modifiers;
  event.kind = state.released ? KeyEvent::Kind::kReleased : KeyEvent::Kind::kPressed;
  return withKnownReleases(event);
}

/// xterm can be set to report keys in this form, without releases.
std::optional<KeyEvent> KeyDecoder::withKnownReleases(std::optional<KeyEvent> event) const {
  if (has_releases_ || !event || event->kind == KeyEvent::Kind::kModifiers) return event;
  if (event->kind == KeyEvent::Kind::kReleased) return std::nullopt;
  event->kind = KeyEvent::Kind::kTyped;
  return event;
}

std::optional<KeyEvent> KeyDecoder::reply(char last) {
  if (last != 'u') return std::nullopt;  // another report of the terminal
  const int flags = firstNumber(std::string_view{digits_}.substr(1));
  has_releases_ = (static_cast<unsigned>(flags) & kReportsReleases) != 0;
  return KeyEvent{KeyEvent::Kind::kReports, flags};
}

}  // namespace darwinop::terminal
