// Where a robot on the floor falls. What follows is of another kind: no foot stands, and impacts of trunk and arms on
// the floor depend on the physics engine.
#pragma once

#include <optional>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// The row from which gravity, averaged over a step, is far from its direction at the start. Axes and scale of the
/// sensor may be wrong: only the angle between its own readings counts.
std::optional<std::size_t> rowOfFall(const std::vector<double>& time_s, const AxesColumns& accel_m_s2);

}  // namespace darwinop::gap
