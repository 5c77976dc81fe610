// Which effects of joints and links may come next, in a joint, a pair and all joints of a robot with a clamped trunk.
#pragma once

#include "gap/identify/body/mechanics_entry.hpp"

namespace darwinop::gap {

/// Fitted candidates in these open limbs, best first. `excess`: cost beyond that of a right model, of each limb. Where
/// an effect of all joints explains nearly all of it, only those of all joints, unless one of them is `refused`.
std::vector<MechanicsEntry> nextMechanics(const ClampedRobot& robot, const std::vector<FoundMechanics>& found,
                                          const std::vector<std::size_t>& open, const std::vector<double>& excess,
                                          const std::vector<PlacedMechanics>& refused = {});

}  // namespace darwinop::gap
