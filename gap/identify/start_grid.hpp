// Parameter values at which the screening evaluates an effect.
#pragma once

#include <vector>

#include "gap/fit/unknown.hpp"

namespace darwinop::gap {

/// Grid of values for the unknowns of an effect, from weak to strong.
std::vector<std::vector<double>> gridOf(const std::vector<Unknown>& unknowns);

}  // namespace darwinop::gap
