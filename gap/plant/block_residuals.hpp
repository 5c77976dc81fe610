// Residuals of one block of the loop on one log.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// Samples of one log. NaN: no information.
struct BlockResiduals {
  Eigen::VectorXd residual;      // measured - expected
  Eigen::VectorXd sigma;         // standard deviation if the model is right
  Eigen::VectorXd z;             // residual over sigma, after what the priors of the numbers explain; NaN as 0
  std::vector<std::size_t> row;  // row of the sample; the middle one for a window
};

using BlockResidualFunction = std::function<BlockResiduals(const Trajectory& log, const Hypothesis& hypothesis)>;

/// Windows of the mechanics.
struct ShootingOptions {
  double length_s = 0.3, stride_s = 0.045;         // of a window, and from one to the next
  bool powered = true, limp = true, mixed = true;  // windows that count: torque on, or off, all the time; or changing
  bool measured_supply = false;                    // the motor gets the measured voltage, not the model's
};

}  // namespace darwinop::gap
