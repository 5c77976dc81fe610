// Reads a whole text file; absent is not the same as unreadable.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace darwinop {

/// Bytes; enough for a settings file of thousands of lines.
inline constexpr std::size_t kLongestTextFile = 1 << 20;
inline constexpr std::size_t kAnyLength = static_cast<std::size_t>(-1);

// Why readTextFile() refuses what is not a regular file.
inline constexpr const char* kFolderInsteadOfFile = "it is a folder";
inline constexpr const char* kPipeInsteadOfFile = "it is a pipe";
inline constexpr const char* kDeviceInsteadOfFile = "it is a device";

/// Empty if the file does not exist. Throws std::runtime_error if it cannot be read: it may contain the robot's limits,
/// without which nothing may move. Also throws if it is not a regular file (a pipe would block, a device may be
/// endless) or longer than `longest`.
std::optional<std::string> readTextFile(const std::string& path, std::size_t longest = kLongestTextFile);

}  // namespace darwinop
