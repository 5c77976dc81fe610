// Closed-loop residuals: the whole loop simulated from the logged goals, against what was measured.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gap/localize/noise_floor.hpp"
#include "gap/study.hpp"

namespace darwinop::gap {

struct LogResidual {
  std::size_t log = 0;  // index in the case
  double rms_rad = 0;
  double floors = 0;             // rms over the floor's
  Eigen::VectorXd position_rad;  // measured - simulated; NaN where masked
  Eigen::VectorXd
      z;  // in standard deviations, after what numbers inside their priors explain; independent; 0 where masked

  [[nodiscard]] double squareSum() const;  // of the positions that are known, rad^2
  [[nodiscard]] double known() const;      // their number
};

/// Residuals of the baseline, one entry for each log of the evidence.
std::vector<LogResidual> residualsOf(const Study& study, const NoiseFloor& floor);

}  // namespace darwinop::gap
