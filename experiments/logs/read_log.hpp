// Reads a log: a recording of the runtime (docs/logs.md), or plain CSV whose columns end in their unit (t_s, pos_rad).
#pragma once

#include <string>
#include <string_view>

#include "experiments/logs/log.hpp"

namespace darwinop::logs {

/// Throws std::runtime_error, "FILE, line N: what is wrong". What can be lived with is a warning in the log: a file
/// that ends in the middle of a row, lost rows. Line ends of Windows and a byte order mark are no matter.
Log readLog(const std::string& path);

/// The same for text that is there already; `file` stands in errors.
Log parseLog(std::string_view text, const std::string& file);

}  // namespace darwinop::logs
