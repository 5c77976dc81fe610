// Robots whose numbers are off within what the case declares uncertain.
#pragma once

#include <cstdint>
#include <vector>

#include "gap/plant/body/floor_roll_out.hpp"

namespace darwinop::gap {

/// Every number that the case declares uncertain, drawn at random around `about`. One robot for each seed from `first`.
std::vector<FloorHypothesis> drawnRobots(const BodyCase& given, const FloorHypothesis& about, std::uint64_t first,
                                         std::size_t count);

}  // namespace darwinop::gap
