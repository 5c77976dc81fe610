// A bench whose numbers differ slightly from those of its model.
#pragma once

#include <map>
#include <string>

#include "core/random.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// Moves every number that has a prior by up to one sigma; returns the factors, by the names of the priors.
std::map<std::string, double> makeWrong(const Case& given, Rng& rng, Hypothesis& bench);

}  // namespace darwinop::gap
