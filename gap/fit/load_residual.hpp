// Load residual, given the position that the servo measured.
#pragma once

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// A duty follows the position error. If the arm sticks a tick away from the model's position, the position residual
/// shows it; the same error is taken out of the load residual.
class LoadResidual {
 public:
  explicit LoadResidual(const Hypothesis& hypothesis, double p_register);
  [[nodiscard]] double operator()(double load, double position, double model_load, double model_position) const;

 private:
  double gain_;  // duty per rad; 0: the load is not a duty
  double most_;  // duty beyond which the law saturates
};

}  // namespace darwinop::gap
