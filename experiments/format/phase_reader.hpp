// Reads one [phase NAME].
#pragma once

#include <string>

#include "experiments/format/experiment.hpp"
#include "experiments/format/sections.hpp"

namespace darwinop::experiments {

/// `swept`: what stands for the word "sweep", empty where nothing is swept. Throws std::runtime_error with file and
/// line.
Phase readPhase(const Section& section, const std::string& swept, const std::string& file);

/// The joint with this name. Throws std::runtime_error with the nearest one.
Joint jointNamed(std::string_view name);

}  // namespace darwinop::experiments
