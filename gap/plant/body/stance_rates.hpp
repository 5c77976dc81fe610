// Angular rate of the trunk by kinematics: if a foot rests on the floor, the measured positions of the joints between
// foot and trunk give it. No mass, contact or servo is simulated, so no physics engine matters.
#pragma once

#include <array>

#include "gap/plant/body/floor_roll_out.hpp"

namespace darwinop::gap {

/// If this foot does not turn. The trace has no positions and no acceleration.
struct StanceRates {
  FloorTrace trace;
  Eigen::MatrixX3d forward, left;  // axes of the foot, in those of the trace's gyroscope; one row for each of the log
  std::vector<bool> known;         // of each row of the log; else positions are missing, and its rate is the last known
};

/// Right foot, left foot. `log`: on the floor, positions of the last firmware cycle before each row. Throws
/// std::runtime_error.
std::array<StanceRates, 2> stanceRates(const BodyCase& given, std::size_t log);

}  // namespace darwinop::gap
