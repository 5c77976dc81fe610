// Rows that a fall on a mechanical stop makes useless: how a stop gives and throws back is not modelled.
#pragma once

#include <cstddef>
#include <vector>

#include "gap/case/body/body_case.hpp"
#include "gap/plant/body/limb.hpp"

namespace darwinop::gap {

/// Of each joint of the limb, the rows that do not count. Where a limp joint has met its stop, none of the limb counts
/// until the servo has caught it and brought it back: on the way back it is off by as much. The joint itself does not
/// count until it has then been moved: dry friction keeps it where the stop had left it.
std::vector<std::vector<bool>> lostAtStops(const BodyCase& given, std::size_t log, const Limb& limb);

}  // namespace darwinop::gap
