// Where a search for an effect begins.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"

namespace darwinop::gap {

/// Values to try for the unknowns of an effect, from hardly visible to plain. Positions that repeat around the turn
/// (cogging) are left to the screen: amplitude and count only.
std::vector<std::vector<double>> gridOf(const std::vector<Unknown>& unknowns);

}  // namespace darwinop::gap
