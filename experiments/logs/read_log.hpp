// Reads a log: a recording of the runtime (docs/logs.md), or plain CSV with units as column suffixes (t_s, pos_rad).
#pragma once

#include <string>
#include <string_view>

#include "experiments/logs/log.hpp"

namespace darwinop::logs {

inline constexpr const char* kTimeGoesBack = "time does not increase";

/// Throws std::runtime_error, "FILE, line N: problem". Recoverable problems (truncated last row, lost rows) are stored
/// as warnings in the log. Accepts Windows line ends and a byte order mark.
Log readLog(const std::string& path);

/// The same for text in memory; `file` is used in messages.
Log parseLog(std::string_view text, const std::string& file);

}  // namespace darwinop::logs
