// Parses sections [Safety] and [Limits], for every file that has them: keys ignore case, unknown keys are errors.
#pragma once

#include <string>
#include <string_view>

#include "safety/config.hpp"

namespace darwinop::safety {

/// True for a key of [Safety] or [Limits]. Such a key in a wrong section must be an error: its limit would be ignored.
bool isLimit(std::string_view key);

/// Parses one line. False: the section is neither of the two.
bool takeSafety(safety::Config& config, std::string_view section, std::string_view key, std::string_view value);

/// Throws std::runtime_error, "FILE, ...", if settings contradict each other.
void checkSafety(const safety::Config& config, const std::string& file);

}  // namespace darwinop::safety
