// Reads a log: a recording of the runtime (docs/logs.md), or plain CSV with units as column suffixes (t_s, pos_rad).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "experiments/logs/log.hpp"

namespace darwinop::logs {

/// Bytes: about two hours of a recording at 8 ms, with 1 KB per cycle.
inline constexpr std::size_t kLongestLog = std::size_t{1} << 30;

inline constexpr const char* kNoEnd = " has no \"# end\"";  // after the file
inline constexpr const char* kTimeGoesBack = "time does not increase";

/// Throws std::runtime_error, "FILE, line N: problem". Recoverable problems (truncated last row, lost rows) are stored
/// as warnings in the log. Accepts Windows line ends and a byte order mark. Also throws if `path` is not a regular file
/// (/dev/zero has no end) or longer than kLongestLog.
Log readLog(const std::string& path);

/// The same for text in memory; `file` is used in messages.
Log parseLog(std::string_view text, const std::string& file);

}  // namespace darwinop::logs
