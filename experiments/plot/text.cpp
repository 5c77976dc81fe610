// Text from a log on its way to a picture or page.
#include "experiments/plot/text.hpp"

#include <charconv>

namespace darwinop::plot {
namespace {

/// Length of the UTF-8 sequence at the start of the text, 0: none that is valid.
std::size_t sequence(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  const std::size_t length = first < 0x80                     ? 1
                             : first >= 0xC2 && first <= 0xDF ? 2
                             : first >= 0xE0 && first <= 0xEF ? 3
                             : first >= 0xF0 && first <= 0xF4 ? 4
                                                              : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  // Overlong forms, surrogates, and what lies above Unicode.
  if ((first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) > 0x9F)) return 0;
  if ((first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) > 0x8F)) return 0;
  return length;
}

}  // namespace

std::string oneLine(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = sequence(text);
    if (length == 0)
      line += '?';
    else if (length == 1 && (text[0] < ' ' || text[0] == '\x7f'))
      line += ' ';
    else
      line += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return line;
}

std::string shortened(const std::string& text, std::size_t length) {
  std::size_t characters = 0, end = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) continue;  // the middle of a character
    if (++characters == length) end = i;
  }
  return characters <= length ? text : text.substr(0, end) + "…";
}

void appendNumber(std::string& out, double value, int digits) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
  out.append(text, end);
}

}  // namespace darwinop::plot
