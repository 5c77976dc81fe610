// How far off a load is, given where the servo saw itself.
#pragma once

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// A duty follows the position; where the arm stuck a tick away from where the model has it, the position says so
/// already, and the load need not say it again.
class LoadResidual {
 public:
  explicit LoadResidual(const Hypothesis& hypothesis, double p_register);
  [[nodiscard]] double operator()(double load, double position, double model_load, double model_position) const;

 private:
  double gain_;  // duty per rad; 0: the load is no duty
  double most_;  // beyond, it does not follow
};

/// Whether the load of this law's servo is the duty of its bridge.
bool loadIsDuty(const Hypothesis& hypothesis);

}  // namespace darwinop::gap
