// The columns of one joint in a log of many, as programs for arms write them: goal_Elbow_rad, pos_Elbow_rad.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/logs/log.hpp"

namespace darwinop::gap {

/// `log` with the columns of this joint under the names of a log of one servo, goal_rad; those of other joints are
/// gone, columns that all joints share (t_s, torque_on, volt_V) stay. A column that a fit can do without, in a unit
/// that is not known, is left out, with a sentence in `notes`. Throws BadInput if the log has no goal of this joint.
logs::Log columnsOfJoint(logs::Log log, std::string_view joint, std::vector<std::string>& notes);

/// With a column torque_on that is `on` in every row, unless the log has one.
logs::Log withTorque(logs::Log log, double on);

}  // namespace darwinop::gap
