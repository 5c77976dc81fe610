// What effects of joints and links leave unexplained in the clamped limbs, and whether their names stand beside it.
#pragma once

#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

/// Cost beyond that of a right model, in each limb.
std::vector<double> excessOf(const ClampedRobot& robot, const BodyHypothesis& hypothesis);
double sumOver(const std::vector<std::size_t>& limbs, const std::vector<double>& of);

/// Drops the effects in limbs that are still open which have not removed most of what they found there, unless the
/// held-out logs show the effect and what it leaves is small in them.
void dropUnexplained(const ClampedRobot& robot, double open_from, MechanicsSelection& selection);

}  // namespace darwinop::gap
