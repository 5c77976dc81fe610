// A whole file of settings as text; absent is not the same as unreadable.
#pragma once

#include <optional>
#include <string>

namespace darwinop::settings {

/// Nothing: there is no such file. Throws std::runtime_error when there is one that cannot be read: the limits of
/// this robot may stand in it, and without them nothing may move.
std::optional<std::string> readTextFile(const std::string& path);

}  // namespace darwinop::settings
