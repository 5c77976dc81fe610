// Writes a whole text file.
#pragma once

#include <string>
#include <string_view>

namespace darwinop {

/// Replaces what the file contained. Throws std::runtime_error: "cannot write PATH: reason".
void writeTextFile(const std::string& path, std::string_view text);

}  // namespace darwinop
