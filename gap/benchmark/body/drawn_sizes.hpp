// Drawn sizes of effects that are hidden: so that recordings of some seconds show them.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/random.hpp"

namespace darwinop::gap {

/// Values by key, in the order of the effect's numbers.
using Values = std::map<std::string, std::vector<double>>;

/// Of an effect of sensor, contact or floor. Throws std::logic_error for another one.
Values drawnFor(const std::string& id, Rng& rng);

/// `neutral` but for one of the three axes, which is `low` to `high` more or less.
std::vector<double> oneAxis(Rng& rng, double neutral, double low, double high);

}  // namespace darwinop::gap
