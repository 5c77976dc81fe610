// Closed-loop position error of a hypothesis: measured minus simulated position over whole logs.
#pragma once

#include <cstdint>

#include "gap/plant/plant.hpp"

namespace darwinop::gap {

enum class LogRole : std::uint8_t { kFit, kHeldOut };

/// Root mean square over all rows of the logs of that role, rad. Copies of a log count once. NaN without such a log.
double rmsPositionError(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role);
/// Mean of |error| of each log, averaged over the logs, rad. A swing that is out of phase weighs less than in the
/// root mean square.
double meanPositionError(const Plant& plant, const Case& data, const Hypothesis& hypothesis, LogRole role);

/// An error on held-out logs that grows by more than fresh noise would make it: the changed model is worse.
bool isWorse(double before_rad, double after_rad, double floor_rad);

}  // namespace darwinop::gap
