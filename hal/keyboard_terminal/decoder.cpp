#include "hal/keyboard_terminal/decoder.hpp"

#include <charconv>

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

/// The second parameter minus one: 1 Shift, 2 Alt, 4 Control.
Key ofModifierNumber(int number) {
  const unsigned bits = number > 0 ? static_cast<unsigned>(number) - 1 : 0;
  return ((bits & 1U) != 0 ? kKeyShift : 0) | ((bits & 2U) != 0 ? kKeyAlt : 0) | ((bits & 4U) != 0 ? kKeyControl : 0);
}

int firstNumber(std::string_view digits) {
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

}  // namespace

std::vector<Key> KeyDecoder::feed(std::string_view bytes, Nanos now) {
  std::vector<Key> keys;
  if (const auto alone = timeOut(now)) keys.push_back(*alone);
  for (const char byte : bytes)
    if (const auto key = take(static_cast<unsigned char>(byte))) keys.push_back(*key);
  last_byte_ = now;
  return keys;
}

std::optional<Key> KeyDecoder::timeOut(Nanos now) {
  if (state_ == State::kPlain || now < last_byte_ + kEscapeAlone) return std::nullopt;
  const State was = state_;
  state_ = State::kPlain;
  if (was != State::kEscape) return std::nullopt;  // a truncated sequence
  return kKeyEscape;
}

std::optional<Key> KeyDecoder::take(unsigned char byte) {
  constexpr std::size_t kLongest = 16;
  if (byte == kEscapeByte) {
    const bool twice = state_ == State::kEscape;
    state_ = State::kEscape;
    if (twice) return kKeyEscape;  // pressed twice, or repeating
    return std::nullopt;
  }
  switch (state_) {
    case State::kPlain:
      break;
    case State::kEscape:
      digits_.clear();
      state_ = byte == '[' ? State::kBracket : byte == 'O' ? State::kLetter : State::kPlain;
      if (state_ != State::kPlain) return std::nullopt;
      if (const auto key = ofCharacter(byte)) return kKeyAlt | *key;
      return std::nullopt;
    case State::kBracket:
    case State::kLetter:
      // The Linux console: ESC [ [ A is F1.
      if (byte == '[' && digits_.empty() && state_ == State::kBracket) {
        digits_ += static_cast<char>(byte);
        return std::nullopt;
      }
      if (byte < '@' && digits_.size() < kLongest) {
        digits_ += static_cast<char>(byte);
        return std::nullopt;
      }
      state_ = State::kPlain;
      return sequence(static_cast<char>(byte));
  }
  return ofCharacter(byte);
}

std::optional<Key> KeyDecoder::sequence(char last) const {
  if (digits_ == "[") {
    if (last >= 'A' && last <= 'E') return kKeyF1 + (last - 'A');
    return std::nullopt;
  }
  if (digits_.starts_with('?')) return std::nullopt;  // a terminal report
  const auto semicolon = digits_.find(';');
  const Key modifiers = semicolon == std::string::npos
                            ? 0
                            : ofModifierNumber(firstNumber(std::string_view{digits_}.substr(semicolon + 1)));
  const auto key = last == '~' ? ofNumber(firstNumber(digits_)) : ofLetter(last);
  if (!key) return std::nullopt;
  return *key | modifiers;
}

}  // namespace darwinop::terminal
