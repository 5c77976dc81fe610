// Simulated repeats of the logs: the baseline under the same commands, with noise and register rounding.
#pragma once

#include <cstdint>
#include <vector>

#include "gap/plant/plant.hpp"

namespace darwinop::gap {

/// One entry for each run, each with one trajectory for each log.
using SimulatedRepeats = std::vector<std::vector<Trajectory>>;

/// `runs`: 8 give a standard deviation to about 25 %.
SimulatedRepeats simulateRepeats(const Plant& plant, const Case& given, const std::vector<std::size_t>& logs,
                                 const Hypothesis& hypothesis, int runs = 8, std::uint64_t seed = 1);

/// One log of the case as `trace` would have been reported. Columns that the log does not have stay empty.
Trajectory asReported(const Trajectory& log, const Trace& trace, double ticks_per_rev, std::uint64_t seed);

}  // namespace darwinop::gap
