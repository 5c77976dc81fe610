// What the picture of the robot shows at each place.
#pragma once

#include "gap/report/body/body_report.hpp"
#include "gap/report/body/robot_picture.hpp"

namespace darwinop::gap {

/// Key of the label of an effect of all joints.
inline constexpr const char* kAllJoints = "all joints";
/// Label of a place where an effect is named and a signal stays open.
inline constexpr const char* kNotAllExplained = "not all explained";

PlaceMarks marksOf(const BodyReport& report);

}  // namespace darwinop::gap
