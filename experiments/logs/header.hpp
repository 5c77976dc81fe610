// Parses the column header of a log.
#pragma once

#include <string>
#include <string_view>

#include "experiments/logs/log.hpp"

namespace darwinop::logs {

/// Calls `each` for every field of a line.
template <class F>
void forEachField(std::string_view line, F&& each) {
  for (;;) {
    const std::size_t comma = line.find(',');
    each(line.substr(0, comma));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

/// A field for error messages: quoted, truncated, without control characters.
[[nodiscard]] std::string quotedField(std::string_view text);

/// Fills columns and time of the log. Throws std::runtime_error without file and line.
void readHeader(std::string_view line, Log& log);

}  // namespace darwinop::logs
