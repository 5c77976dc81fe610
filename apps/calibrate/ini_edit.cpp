#include "apps/calibrate/ini_edit.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "core/text/letter_case.hpp"
#include "core/text/number_text.hpp"
#include "hal/replace_file.hpp"

namespace darwinop::calibrate {
namespace {

using text::lowered;
using text::withoutBlanks;

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Name of the section that this line begins; empty: none.
std::string sectionOf(const std::string& line) {
  const std::string_view shown = withoutBlanks(line);
  const std::size_t end = shown.find(']');
  if (!shown.starts_with('[') || end == shown.npos) return {};
  return lowered(shown.substr(1, end - 1));
}

/// Key of a line, in lower case; empty: a comment or no pair.
std::string keyOf(const std::string& line) {
  const std::string_view shown = withoutBlanks(line);
  if (shown.empty() || shown.front() == '#' || shown.front() == ';' || shown.front() == '[') return {};
  return lowered(withoutBlanks(shown.substr(0, shown.find_first_of("=:"))));
}

std::string lineOf(const IniValue& value) {
  return value.key + " = " + value.value + (value.comment.empty() ? "" : "  # " + value.comment);
}

[[noreturn]] void refuse(const std::string& path, const std::string& what = "cannot write ") {
  throw std::runtime_error(what + path + ": " + std::strerror(errno));
}

/// A second name of the old file: its bytes are never copied. An existing name is never taken.
std::string keep(const std::string& path, const std::string& stamp) {
  const std::string first = path + ".before-" + stamp;
  std::string kept = first;
  for (int number = 2; link(path.c_str(), kept.c_str()) != 0; ++number) {
    if (errno == ENOENT) return {};
    if (errno != EEXIST || number > 99) refuse(kept);
    kept = first;
    kept.append("-").append(std::to_string(number));
  }
  return kept;
}

}  // namespace

std::string withValues(std::string_view text, std::string_view section, const std::vector<IniValue>& values) {
  std::vector<std::string> lines = linesOf(text);
  const auto begin =
      std::ranges::find_if(lines, [&](const std::string& line) { return sectionOf(line) == lowered(section); });
  auto first = static_cast<std::size_t>(begin - lines.begin());
  if (begin == lines.end()) {
    if (!lines.empty() && !withoutBlanks(lines.back()).empty()) lines.emplace_back();
    first = lines.size();
    lines.push_back('[' + std::string{section} + ']');
  }
  std::size_t last = first;  // with text, of the section
  for (std::size_t i = first + 1; i < lines.size() && sectionOf(lines[i]).empty(); ++i)
    if (!keyOf(lines[i]).empty()) last = i;
  for (const IniValue& value : values) {
    const auto from = lines.begin() + static_cast<std::ptrdiff_t>(first) + 1;
    const auto to = lines.begin() + static_cast<std::ptrdiff_t>(last) + 1;
    const auto line = std::find_if(from, to, [&](const std::string& one) { return keyOf(one) == lowered(value.key); });
    if (line != to)
      *line = lineOf(value);
    else
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(++last), lineOf(value));
  }
  std::string out;
  for (const std::string& line : lines) out += line + '\n';
  return out;
}

std::string replaceKeepingOld(const std::string& path, std::string_view text, const std::string& stamp) {
  const std::string file = linkedFile(path);
  const std::string fresh = writeBeside(file, text);
  try {
    std::string kept = keep(file, stamp);
    flushFolder(file);
    if (rename(fresh.c_str(), file.c_str()) != 0) refuse(file, "cannot replace ");
    flushFolder(file);
    return kept;
  } catch (...) {
    unlink(fresh.c_str());
    throw;
  }
}

}  // namespace darwinop::calibrate
