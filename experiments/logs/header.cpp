// Parses the column header of a log: names, units, time column.
#include "experiments/logs/header.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <unordered_set>

#include "experiments/logs/units.hpp"

namespace darwinop::logs {
namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

bool isNumber(std::string_view field) {
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return error == std::errc{} && end == field.data() + field.size();
}

Column columnOf(std::string_view field) {
  const std::string_view text = trimmed(field);
  if (text.empty()) throw std::runtime_error("a column has no name; name every column, as in \"t_s,pos_rad\"");
  const std::size_t bracket = text.rfind(" [");
  if (bracket == std::string_view::npos || text.back() != ']')
    return {std::string{text}, std::string{unitOfSuffix(text)}, {}};
  const std::string_view unit = text.substr(bracket + 2, text.size() - bracket - 3);
  if (!isUnit(unit))
    throw std::runtime_error("the unit of column " + quotedField(text) + " is unknown; known units: " + unitNames());
  return {std::string{trimmed(text.substr(0, bracket))}, std::string{unit}, {}};
}

bool isTime(const Column& column) {
  const std::string_view name = withoutSuffix(column.name);
  return name == "time" || name == "t";
}

void findTime(Log& log) {
  const auto time = std::find_if(log.columns.begin(), log.columns.end(), isTime);
  if (time == log.columns.end()) throw std::runtime_error("no time column; name one time_s, t_s or \"time [s]\"");
  const auto second = secondsIn(time->unit);
  if (!second)
    throw std::runtime_error("column " + quotedField(time->name) + " needs a time unit: write " + time->name +
                             "_s, or _ms, or _us");
  log.time = static_cast<std::size_t>(time - log.columns.begin());
  log.second = *second;
}

}  // namespace

std::string quotedField(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown = "\"";
  for (const char c : text.substr(0, kShown)) shown += (c >= ' ' && c != '\x7f') || c < 0 ? c : '?';
  return shown + (text.size() > kShown ? "…\"" : "\"");
}

void readHeader(std::string_view line, Log& log) {
  if (line.find(',') == std::string_view::npos && line.find(';') != std::string_view::npos)
    throw std::runtime_error(
        "fields are separated by \";\"; save the file with commas as separators and decimal points");
  bool numbers = true;
  forEachField(line, [&](std::string_view field) { numbers = numbers && isNumber(trimmed(field)); });
  if (numbers) throw std::runtime_error("no header; name the columns in the first line, as in \"t_s,pos_rad\"");
  std::unordered_set<std::string> names;
  forEachField(line, [&](std::string_view field) {
    Column column = columnOf(field);
    if (!names.insert(column.name).second)
      throw std::runtime_error("two columns are named " + quotedField(column.name) + "; rename one");
    log.columns.push_back(std::move(column));
  });
  findTime(log);
}

}  // namespace darwinop::logs
