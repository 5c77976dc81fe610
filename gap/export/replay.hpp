// A target's joint under the commands of a log.
#pragma once

#include <vector>

#include "gap/export/joints.hpp"
#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// Position of the joint at each row of the log, as its servo would have answered. `step_s`: of the target.
/// `firmware_period_s`: of the servo, which answers with the position that its firmware read last.
std::vector<double> replay(const Trajectory& log, GoalOrder order, TargetJoint& joint, double step_s,
                           double firmware_period_s);

}  // namespace darwinop::gap
