// Writes a whole text file.
#pragma once

#include <string>
#include <string_view>

namespace darwinop {

/// Replaces what the file contained. A file of this user is replaced at once, so that a failure leaves it as it was;
/// what cannot be replaced, and everything below /dev and /proc, is written into. Throws std::runtime_error: "cannot
/// write PATH: reason".
void writeTextFile(const std::string& path, std::string_view text);

}  // namespace darwinop
