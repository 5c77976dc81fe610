// What the picture of the robot shows at each place.
#pragma once

#include "gap/report/body/body_report.hpp"
#include "gap/report/body/robot_picture.hpp"

namespace darwinop::gap {

PlaceMarks marksOf(const BodyReport& report);

}  // namespace darwinop::gap
