// Which effects of joints and links may come next, in a joint, a pair and all joints of a robot with a clamped trunk.
#pragma once

#include "gap/identify/body/mechanics_entry.hpp"

namespace darwinop::gap {

/// Fitted candidates in these open limbs, best first. `excess`: cost beyond that of a right model, of each limb.
std::vector<MechanicsEntry> nextMechanics(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                          const std::vector<std::size_t>& open, const std::vector<double>& excess);

}  // namespace darwinop::gap
