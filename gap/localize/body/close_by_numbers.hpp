// A limb is open only where numbers within their priors, fitted together, leave a gap.
#pragma once

#include <vector>

#include "gap/localize/body/body_table.hpp"

namespace darwinop::gap {

/// Limbs with an open row; `rows`: mechanicsRows().
std::vector<std::size_t> openLimbs(const ClampedRobot& robot, const std::vector<BodyRow>& rows, double open_from);

/// Fits the numbers of limbs that are open under the hypothesis. A limb that they close keeps them, and is judged about
/// them from then on; another one stays as it is. `limbs`: that are looked at. True: one was closed.
bool closeByNumbers(ClampedRobot& robot, const std::vector<std::size_t>& limbs, const BodyHypothesis& hypothesis,
                    double open_from);

}  // namespace darwinop::gap
