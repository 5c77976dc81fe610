// Closed-loop simulation of a log: the same commands at the same times, on a hypothesis.
#pragma once

#include "gap/plant/bench/bench_plant.hpp"

namespace darwinop::gap {

/// s. A host that commands after it reads has held its goal this long before row 0, heldBefore(); one that commands
/// first starts from rest.
inline constexpr double kHeldBefore = 1.0;
/// Of a firmware period: how far a firmware that runs on its own is ahead of the rows, on average.
inline constexpr double kMeanPhase = 0.5;

/// Reuses the memory of `trace`. May run in several threads at once, each with a trace of its own. Throws
/// std::runtime_error for an impossible hypothesis (no inertia left).
void rollOut(const Case& given, std::size_t log, const Hypothesis& hypothesis, const RollOutOptions& options,
             Trace& trace);

}  // namespace darwinop::gap
