// Joint refit of effects that forward selection has added one by one, and backward elimination.
#pragma once

#include <vector>

#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

/// Re-estimates the noise with the current effects, then fits the effects in the limbs of the last one jointly. Effects
/// that were identified from loads alone stay fixed.
void refitMechanics(ClampedRobot& robot, std::vector<FoundMechanics>& found);

/// Backward elimination: removes an effect if the cost without it, after a refit of the others in its limbs, rises by
/// less than its price. Such an effect was a substitute for one that was added later. Effects identified from loads are
/// tested as well: a delay of nearly one row is identified there as a derivative first. Returns the limbs of the
/// removed effects, with their noise re-estimated.
std::vector<std::size_t> dropSuperfluous(ClampedRobot& robot, std::vector<FoundMechanics>& found);

}  // namespace darwinop::gap
