// A log in memory: looking things up.
#include "experiments/logs/log.hpp"

#include <algorithm>
#include <stdexcept>

namespace darwinop::logs {

std::optional<std::string> Log::headValue(std::string_view key) const {
  const auto line = std::find_if(head.begin(), head.end(), [&](const HeadLine& l) { return l.key == key; });
  return line == head.end() ? std::nullopt : std::optional{line->value};
}

const Column* Log::find(std::string_view name) const {
  const auto column = std::find_if(columns.begin(), columns.end(), [&](const Column& c) { return c.name == name; });
  return column == columns.end() ? nullptr : &*column;
}

const Column& Log::column(std::string_view name) const {
  if (const Column* found = find(name)) return *found;
  constexpr std::size_t kNamed = 12;  // a recording has 285
  std::string there;
  for (std::size_t i = 0; i < std::min(columns.size(), kNamed); ++i)
    there.append(i == 0 ? "" : ", ").append(columns[i].name);
  if (columns.size() > kNamed) there += " and " + std::to_string(columns.size() - kNamed) + " more";
  throw std::runtime_error(file + ": no column \"" + std::string{name} + "\"; there are " + there);
}

}  // namespace darwinop::logs
