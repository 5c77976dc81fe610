// Reads gait parameters from an INI file, section [Walking Config].
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "managers/gait/parameters.hpp"

namespace darwinop::gait {

struct WalkingConfig {
  Parameters parameters;
  std::vector<std::string> warnings;  // messages; the robot can still walk
};

/// Parses the text of `file`; other sections are ignored. Throws std::runtime_error with file, line, key and allowed
/// range for an invalid value.
WalkingConfig parseWalkingConfig(std::string_view text, const std::string& file);

/// Message about the first value out of its range, or NaN, with the range; empty: all are in range.
std::string findParameterError(const Parameters& parameters);

/// Warning of readWalkingConfig() for an empty name, which upstream's controllers may pass.
inline constexpr const char* kNoConfigName =
    "the gait manager got an empty file name: the default gait parameters are used; pass \"config.ini\" to read its "
    "section [Walking Config]";

/// Reads `path`. A missing file gives the defaults and a warning; a read error throws.
WalkingConfig readWalkingConfig(const std::string& path);

}  // namespace darwinop::gait
