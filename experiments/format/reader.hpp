// Parses an experiment file.
#pragma once

#include <string>
#include <string_view>

#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {

/// Throws std::runtime_error, "FILE, line N: problem and allowed values". Joint limits are checked by makePlan().
Experiment parseExperiment(std::string_view text, const std::string& file);

Experiment readExperiment(const std::string& path);

}  // namespace darwinop::experiments
