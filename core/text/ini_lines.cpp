// Lines of an INI text for inih, with the liberties that robots' files have taken since 2013.
#include "core/text/ini_lines.hpp"

#include <algorithm>

#include "core/text/number_text.hpp"

namespace darwinop::text {

std::string_view withoutComment(std::string_view line) {
  return withoutBlanks(line.substr(0, std::min(line.find_first_of(";#"), line.size())));
}

std::string_view withoutQuotes(std::string_view value) {
  value = withoutBlanks(value);
  if (value.size() >= 2 && value.front() == '"' && value.back() == '"') value = value.substr(1, value.size() - 2);
  return value;
}

IniLines::IniLines(std::string_view text) : rest_{text} {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // some editors begin files with it
  if (rest_.starts_with(kByteOrderMark)) rest_.remove_prefix(kByteOrderMark.size());
}

char* IniLines::next(char* into, int size) {
  if (rest_.empty() || size < 2) return nullptr;
  const std::size_t length = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = withoutComment(rest_.substr(0, length));
  rest_.remove_prefix(std::min(length + 1, rest_.size()));
  ++number_;
  const std::size_t room = static_cast<std::size_t>(size) - 1;
  if (line.size() > room) cut_ = number_;
  line = line.substr(0, std::min(line.find('\0'), room));
  *std::copy(line.begin(), line.end(), into) = '\0';
  return into;
}

}  // namespace darwinop::text
