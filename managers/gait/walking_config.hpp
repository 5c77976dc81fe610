// Reads the gait's parameters from an INI file, section [Walking Config].
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "managers/gait/parameters.hpp"

namespace darwinop::gait {

struct WalkingConfig {
  Parameters parameters;
  std::vector<std::string> warnings;  // sentences; the robot can walk
};

/// Reads the text of a file called `file`; other sections are others' business. Throws std::runtime_error that names
/// file, line, key and what is allowed when a value is wrong.
WalkingConfig parseWalkingConfig(std::string_view text, const std::string& file);

/// Reads `path`; a file that is not there gives the defaults and a warning, one that cannot be read throws.
WalkingConfig readWalkingConfig(const std::string& path);

}  // namespace darwinop::gait
