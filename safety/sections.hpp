// [Safety] and [Limits], the same in every file that has them: keys in any case, wrong ones are errors.
#pragma once

#include <string>
#include <string_view>

#include "safety/config.hpp"

namespace darwinop::safety {

/// A key of [Safety] or [Limits]: where such a one is ignored, a limit does not limit.
bool isLimit(std::string_view key);

/// Takes one line. False: the section is neither of the two.
bool takeSafety(safety::Config& config, std::string_view section, std::string_view key, std::string_view value);

/// Throws std::runtime_error, "FILE, ...", when settings contradict each other.
void checkSafety(const safety::Config& config, const std::string& file);

}  // namespace darwinop::safety
