// A bench whose numbers are not quite those that its model believes.
#pragma once

#include <map>
#include <string>

#include "gap/hide/dice.hpp"
#include "gap/sim/hypothesis.hpp"

namespace darwinop::gap {

/// Moves every number that has a prior by up to one sigma; returns the factors, by the names of the priors.
std::map<std::string, double> makeWrong(const Case& given, Dice& dice, Hypothesis& bench);

}  // namespace darwinop::gap
