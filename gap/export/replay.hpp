// A target's joint under the commands of a log.
#pragma once

#include <vector>

#include "gap/export/joints.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// Position of the joint at each row of the log, as its servo would have answered: with the position that its firmware
/// read last. `step_s`: of the target. `hypothesis`: for the firmware's period and the instants of the writes.
std::vector<double> replay(const Trajectory& log, GoalOrder order, TargetJoint& joint, double step_s,
                           const Hypothesis& hypothesis);

}  // namespace darwinop::gap
