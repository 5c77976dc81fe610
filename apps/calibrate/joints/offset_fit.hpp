// Zero offsets of joints from the load under gravity: a hanging limb shows where down is.
#pragma once

#include <vector>

#include "apps/calibrate/joints/gravity_model.hpp"
#include "apps/calibrate/joints/sweep.hpp"

namespace darwinop::calibrate {

struct JointOffset {
  Joint joint;
  double offset_rad;  // reading where the joint is at 0
  double sigma_rad;
  bool observed;  // false: gravity does not show this offset well enough
};

/// Offsets of the joints that were swept. The scale of each joint's load is fitted with its offset, because it depends
/// on motor and supply.
std::vector<JointOffset> fitOffsets(const std::vector<GravityPoint>& points, GravityModel& gravity);

}  // namespace darwinop::calibrate
