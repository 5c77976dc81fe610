// [Safety] and [Limits], the same in every file that has them: keys in any case, wrong ones are errors.
#pragma once

#include <string>
#include <string_view>

#include "safety/config.hpp"

namespace darwinop::settings {

std::string lowered(std::string_view text);

/// The joint's own spelling: keys of an INI file may be written in any case.
std::string_view jointName(std::string_view key);

/// A key of [Safety] or [Limits]: where such a one is ignored, a limit does not limit.
bool isLimit(std::string_view key);

/// Takes one line. False: the section is neither of the two.
bool takeSafety(safety::Config& config, std::string_view section, std::string_view key, std::string_view value);

/// Throws std::runtime_error, "FILE, ...", when settings contradict each other.
void checkSafety(const safety::Config& config, const std::string& file);

/// Safety's own sentences begin with the usual name of the file; readers put the path before them.
std::string_view withoutFile(std::string_view sentence);

}  // namespace darwinop::settings
