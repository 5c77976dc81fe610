// Which effects of command and control law explain the loads, before anything is simulated: forward selection over
// joints, pairs and all, as that of the mechanics.
#pragma once

#include "gap/identify/body/mechanics_selection.hpp"

namespace darwinop::gap {

/// In the order in which they were found; each removes nearly all that the loads of its joints had of a gap.
std::vector<FoundMechanics> identifyControllers(const BodyCase& given, const BodyHypothesis& baseline,
                                                double open_from);

}  // namespace darwinop::gap
