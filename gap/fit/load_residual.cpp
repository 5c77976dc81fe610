#include "gap/fit/load_residual.hpp"

#include <cmath>

namespace darwinop::gap {

LoadResidual::LoadResidual(const Hypothesis& hypothesis, double p_register)
    : gain_{loadIsDuty(hypothesis) ? hypothesis.servo.duty_per_kp_per_rad * p_register : 0},
      most_{0.99 * hypothesis.servo.duty_max} {
  gain_ *= hypothesis.value(twin::ParameterRole::kGainFactor).value_or(1);
}

double LoadResidual::operator()(double load, double position, double model_load, double model_position) const {
  const bool follows = model_load != 0 && load != 0 && std::abs(load) < most_ && std::abs(model_load) < most_;
  return load - model_load + (follows ? gain_ * (position - model_position) : 0);
}

}  // namespace darwinop::gap
