// Centre of mass and inertia of the trunk: contradicting sources, selected by the model file.
#pragma once

#include <mujoco/mujoco.h>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// In the trunk frame: x left, y up, z forward, m.
std::array<double, 3> trunkCom(TrunkCom choice);
void setTrunk(mjModel& m, int trunk, const BodySettings& settings);

}  // namespace darwinop::twin
