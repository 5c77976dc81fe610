// Parses a section [phase NAME].
#pragma once

#include <string>

#include "experiments/format/experiment.hpp"
#include "experiments/format/sections.hpp"

namespace darwinop::experiments {

/// `swept`: value that replaces the word "sweep"; empty without a sweep. Throws std::runtime_error with file and line.
Phase readPhase(const Section& section, const std::string& swept, const std::string& file);

/// The joint with this name. Throws std::runtime_error with the closest name.
Joint jointNamed(std::string_view name);

}  // namespace darwinop::experiments
