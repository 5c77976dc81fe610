#include "gap/report/model_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "core/text/letter_case.hpp"
#include "core/text/nearest.hpp"
#include "core/text/number_text.hpp"
#include "twin/model/keys.hpp"
#include "twin/model/sections.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kLongest = 198;  // characters that a line of a model file may have
constexpr std::size_t kLine = 110;     // of them

std::string fourDigits(double value) {
  return text::generalText(value, 4);
}

/// A key of this section whose value is a `Value`.
template <class Value>
const twin::KeyRow& rowOf(std::string_view section, const std::string& key) {
  twin::Model some;
  const twin::KeyRow* const row = twin::findKey(section, key);
  if (row == nullptr || !std::holds_alternative<Value*>(row->in(some)))
    throw std::runtime_error("[" + std::string{section} + "] has no number '" + key + "'; " +
                             text::suggestion(key, twin::keysOf(section)));
  return *row;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// "kt" of "Kt = 1.786 N m/A" or "kt: 1.786 N m/A"; empty: no pair.
std::string keyIn(std::string_view line) {
  const std::size_t end = line.find_first_of("=:");
  const std::string_view said = trimmed(line);
  if (end == std::string_view::npos || said.starts_with(';') || said.starts_with('#')) return {};
  return text::lowered(trimmed(line.substr(0, end)));
}

/// Of the line "[link armlowerr]  ; comment": "link ArmLowerR"; empty: an effect.
std::string_view sectionOf(std::string_view line) {
  const std::size_t begin = line.find('[') + 1;
  return twin::sectionFrom(line.substr(begin, line.find(']') - begin)).plain;
}

/// Instead of `line`: `now`, and behind it what the line had as a comment, or above it where that is too long.
std::string replacedLine(std::string_view line, const std::string& now, std::string_view line_end) {
  const std::size_t comment = line.find_first_of(";#");
  const std::string note{comment == std::string_view::npos ? "" : trimmed(line.substr(comment + 1))};
  if (note.empty()) return now;
  if (now.size() + note.size() + 2 <= kLongest) return now + "; " + note;
  return ("; " + note).append(line_end) + now;
}

/// `text` with another value for a key of the model.
template <class Value>
std::string withValue(std::string_view text, const twin::KeyRow& row, const Value& value) {
  const std::string header = "[" + std::string{row.section} + "]";
  twin::Model changed = twin::parseModel(text, "the model");
  const std::string was = twin::writeValue(changed, row);
  *std::get<Value*>(row.in(changed)) = value;
  const std::string now = std::string{row.key} + " = " + twin::writeValue(changed, row) + "  ; was " + was;
  const std::string line_end = text.substr(0, text.find('\n')).ends_with('\r') ? "\r\n" : "\n";
  std::string out;
  std::size_t below = std::string::npos;  // in `out`: behind the last line of the section that says something
  bool in_section = false, done = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = text.substr(at, end - at);
    const bool is_header = trimmed(line).starts_with('[');
    if (is_header) in_section = sectionOf(line) == row.section;
    const bool here = in_section && !done && keyIn(line) == row.key;
    out += here ? replacedLine(line, now, line_end) + line_end : std::string{line} + "\n";
    done = done || here;
    if (in_section && (is_header || !keyIn(line).empty())) below = out.size();
    at = end + 1;
  }
  if (!done && below == std::string::npos)
    out += line_end + header + line_end + now + line_end;
  else if (!done)
    out.insert(below, now + line_end);
  twin::parseModel(out, "the model");  // a value out of its range is refused here
  return out;
}

}  // namespace

std::string withNumber(std::string_view text, std::string_view section, const std::string& key, double value) {
  return withValue(text, rowOf<double>(section, key), value);
}

std::string withAxes(std::string_view text, std::string_view section, const std::string& key,
                     const std::array<double, 3>& values) {
  return withValue(text, rowOf<std::array<double, 3>>(section, key), values);
}

std::vector<MovedNumber> movedNumbers(const twin::ServoParameters& before, const twin::ServoParameters& after) {
  std::vector<MovedNumber> moved;
  twin::Model old_model, new_model;
  old_model.servo = before, new_model.servo = after;
  for (const twin::KeyRow& row : twin::keyTable()) {
    if (row.section != "servo" || !std::holds_alternative<double*>(row.in(old_model))) continue;
    const double was = *std::get<double*>(row.in(old_model)), now = *std::get<double*>(row.in(new_model));
    if (was != now) moved.push_back({std::string{row.key}, std::string{row.number.unit}, was, now});
  }
  return moved;
}

std::vector<std::string> wrapped(const std::vector<std::string>& comments) {
  std::vector<std::string> lines;
  for (std::string rest : comments) {
    while (rest.size() > kLine) {
      std::size_t cut = rest.rfind(' ', kLine);
      if (cut == std::string::npos || cut < 3) cut = kLine;  // one long word; 2: the indent
      lines.push_back(rest.substr(0, cut));
      rest = "  " + rest.substr(std::min(rest.size(), rest.find_first_not_of(' ', cut)));
    }
    lines.push_back(rest);
  }
  return lines;
}

double forReading(double value) {
  if (value == std::round(value)) return value;
  return std::strtod(text::generalText(value, 6).c_str(), nullptr);
}

std::string withUnit(double value, std::string_view unit) {
  return fourDigits(value) + (unit.empty() ? "" : " ") + std::string{unit};
}

std::string interval(double low, double high, std::string_view unit) {
  return fourDigits(low) + " to " + withUnit(high, unit);
}

}  // namespace darwinop::gap
