// The trunk's centre of mass and inertia: two doubtful facts, and the choices a model file has.
#pragma once

#include <mujoco/mujoco.h>

#include "twin/model/model.hpp"

namespace darwinop::twin {

/// Link frame of the trunk: x left, y up, z forward, m.
std::array<double, 3> trunkCom(TrunkCom choice);
void setTrunk(mjModel& m, int trunk, const BodySettings& settings);

}  // namespace darwinop::twin
