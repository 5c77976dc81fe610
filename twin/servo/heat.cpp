// Thermal model and overload protection.
#include "twin/servo/heat.hpp"

#include <cmath>

namespace darwinop::twin {
namespace {

constexpr double kStallSpeed = 0.05;  // fraction of the no-load speed
// Minimum duty for an overload. The 2013 test of the torque limit raised it slowly from 0 under a hanging arm; the duty
// stayed at the limit up to the arm's weight (8 %) and no servo tripped.
constexpr double kHarmlessDuty = 0.3;

}  // namespace

double temperatureAfter(const Signals& s, const ServoParameters& parameters, double dt_s) noexcept {
  const double loss_w = s.current_a * s.current_a * s.resistance_ohm;
  const double cooling_w = (s.temperature_c - parameters.ambient_c) / parameters.heat_resistance_k_w;
  return s.temperature_c + (loss_w - cooling_w) / parameters.heat_capacity_j_k * dt_s;
}

void OverloadGuard::step(const Signals& s, const ServoParameters& parameters, double dt_s) noexcept {
  if (!s.torque_on || s.law == Law::kSpeedP) {  // Webots' motors have no protection
    *this = {};
    return;
  }
  const double duty = std::abs(s.duty);
  const bool at_limit = duty >= parameters.overload_share * s.duty_limit && duty >= kHarmlessDuty;
  const bool stalled = std::abs(s.velocity_rad_s) * parameters.back_emf_vs_rad < kStallSpeed * parameters.supply_v;
  for_s_ = at_limit && stalled ? for_s_ + dt_s : 0;
  // Half a period: rounding of the summed periods.
  tripped_ = tripped_ || for_s_ > parameters.overload_time_s - dt_s / 2;
}

}  // namespace darwinop::twin
