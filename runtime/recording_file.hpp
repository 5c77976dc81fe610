// The file of a recording: what it may replace, and whether it is complete.
#pragma once

#include <string>

namespace darwinop::runtime {

/// First line of a recording.
inline constexpr const char* kRecordingHead = "# darwinop log, format 1\n";
/// Last line: everything before it is on the disk.
inline constexpr const char* kEndOfRecording = "# end\n";

/// Before it, with their number, if the disk was too slow for some rows; experiments/logs reads it.
inline constexpr const char* kLostRows = "# lost rows: ";

/// For the programs that take --record FILE. Throws std::runtime_error if a regular file has this name.
void requireNewRecording(const std::string& path);

/// Of the recordings that a daemon or DARWINOP_RECORD writes again and again. Throws std::runtime_error if the regular
/// file `path` has other content than a recording.
void requireReplaceableRecording(const std::string& path);

/// True if the recording in `path`, whose Recorder no longer exists, has its last line and lacks no row. True also if
/// `path` is not a regular file: what went into a pipe cannot be read back.
[[nodiscard]] bool isCompleteRecording(const std::string& path);

}  // namespace darwinop::runtime
