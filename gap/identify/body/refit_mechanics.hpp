// Effects that were found one after the other, fitted together: the first ones were found beside what was not known
// yet.
#pragma once

#include <vector>

#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

/// Estimates the noise about what was found, and fits all numbers in the limbs of the last effect together. What the
/// loads show by themselves stays.
void refitMechanics(ClampedRobot& robot, std::vector<FoundMechanics>& found);

/// Takes an effect away if the others in its limbs, fitted again, lose less by it than its price: it stood in for one
/// that was found later. Returns the limbs in which something was taken away; their noise is estimated again.
std::vector<std::size_t> dropSuperfluous(ClampedRobot& robot, std::vector<FoundMechanics>& found);

}  // namespace darwinop::gap
