// Reports a recording after its session, and whether all of it is on the disk.
#pragma once

#include <string>

namespace darwinop::experiments {

inline constexpr const char* kRecorded = "recorded: ";                // then the file
inline constexpr const char* kRecordedInPart = "recorded in part: ";  // then the file

/// Prints where the recording is. False: it is incomplete, as on a full disk; the recorder has printed the cause. Call
/// after the end of the session, which completes it. `path`: as for --record; empty: none.
[[nodiscard]] bool reportRecording(const std::string& path);

}  // namespace darwinop::experiments
