#include "core/text/printable.hpp"

namespace darwinop::text {
namespace {

unsigned char byteAt(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// `character`: one valid UTF-8 sequence.
bool controls(std::string_view character) {
  const unsigned char first = byteAt(character, 0);
  if (character.size() == 1) return first < 0x20 || first == 0x7F;
  const unsigned char second = byteAt(character, 1);
  if (character.size() == 2) return first == 0xC2 && second < 0xA0;  // C1, with a CSI of its own
  if (character.size() != 3 || first != 0xE2) return false;
  const unsigned char third = byteAt(character, 2);
  // U+2028 to U+202E: line and paragraph separator, direction; U+2066 to U+2069: direction.
  return (second == 0x80 && third >= 0xA8 && third <= 0xAE) || (second == 0x81 && third >= 0xA6 && third <= 0xA9);
}

}  // namespace

std::size_t utf8Length(std::string_view text) {
  const unsigned char first = byteAt(text, 0);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byteAt(text, i) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates, and what lies above Unicode.
  if ((first == 0xE0 && byteAt(text, 1) < 0xA0) || (first == 0xED && byteAt(text, 1) > 0x9F)) return 0;
  if ((first == 0xF0 && byteAt(text, 1) < 0x90) || (first == 0xF4 && byteAt(text, 1) > 0x8F)) return 0;
  return length;
}

std::string printable(std::string_view text) {
  constexpr std::string_view kHexDigits = "0123456789abcdef";
  std::string line;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    if (length > 0 && !controls(character)) {
      line += character;
    } else {
      for (const char byte : character) {
        line += "\\x";
        line += kHexDigits[static_cast<unsigned char>(byte) >> 4];
        line += kHexDigits[static_cast<unsigned char>(byte) & 15];
      }
    }
    text.remove_prefix(character.size());
  }
  return line;
}

std::string printableLines(std::string_view text) {
  std::string lines;
  for (;;) {
    const std::size_t end = text.find('\n');
    lines += printable(text.substr(0, end));
    if (end == std::string_view::npos) return lines;
    lines += '\n';
    text.remove_prefix(end + 1);
  }
}

}  // namespace darwinop::text
