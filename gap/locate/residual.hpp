// The gap that a user sees: the whole loop rolled out from the same goals, against what was measured.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/locate/floor.hpp"

namespace darwinop::gap {

struct LogResidual {
  std::size_t log = 0;  // index in the case
  double rms_rad = 0;
  double floors = 0;             // rms over the floor's
  Eigen::VectorXd position_rad;  // measured - simulated
  Eigen::VectorXd z;             // in standard deviations, after what numbers inside their priors explain; independent
};

/// Of the baseline, one a log of the evidence.
std::vector<LogResidual> residualsOf(const Case& given, const Evidence& evidence, const NoiseFloor& floor);

}  // namespace darwinop::gap
