// From an experiment's file to an Experiment.
#pragma once

#include <string>
#include <string_view>

#include "experiments/format/experiment.hpp"

namespace darwinop::experiments {

/// Throws std::runtime_error, "FILE, line N: what is wrong and what is allowed". Whether joints may go where the
/// experiment sends them is checked by makePlan().
Experiment parseExperiment(std::string_view text, const std::string& file);

Experiment readExperiment(const std::string& path);

}  // namespace darwinop::experiments
