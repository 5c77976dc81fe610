// A whole file of settings as text; absent is not the same as unreadable.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace darwinop {

/// Bytes. A settings file of thousands of lines; more is another kind of file.
inline constexpr std::size_t kLongestTextFile = 1 << 20;

/// Nothing: there is no such file. Throws std::runtime_error when there is one that cannot be read: the limits of
/// this robot may stand in it, and without them nothing may move. What is no regular file (a pipe would wait for its
/// writer, a device may have no end) and what is longer than `longest` is refused.
std::optional<std::string> readTextFile(const std::string& path, std::size_t longest = kLongestTextFile);

}  // namespace darwinop
