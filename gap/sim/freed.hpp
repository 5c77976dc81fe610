// Effects that mean a number of the baseline: heavier than it says, or more friction than it has.
#pragma once

#include <string_view>

#include "gap/sim/hypothesis.hpp"

namespace darwinop::gap {

/// True: `number` being off is what the effect says.
bool means(const twin::EffectInfo& effect, std::string_view number);

/// True: the effect only frees a number of the baseline that has a prior (coulomb where there is friction already).
bool freesAPrior(const Case& given, const twin::EffectInfo& effect);

/// How far `hypothesis`, which has the effect, moves the number that it means, in sigmas of its prior; infinite where
/// there is none.
double sigmasOfFreed(const Case& given, const Hypothesis& hypothesis, const twin::EffectInfo& effect);

}  // namespace darwinop::gap
