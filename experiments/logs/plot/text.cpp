// Sanitizes text from logs for pictures and HTML.
#include "experiments/logs/plot/text.hpp"

#include "core/text/printable.hpp"

namespace darwinop::plot {

std::string oneLine(std::string_view text) {
  std::string line;
  while (!text.empty()) {
    const std::size_t length = text::utf8Length(text);
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
    if ((static_cast<unsigned char>(text[i]) & 0xC0) == 0x80) continue;  // UTF-8 continuation byte
    if (++characters == length) end = i;
  }
  return characters <= length ? text : text.substr(0, end) + "…";
}

}  // namespace darwinop::plot
