// Heat and overload.
#include "twin/servo/heat.hpp"

#include <cmath>

namespace darwinop::twin {
namespace {

constexpr double kStandsBelow = 0.05;  // share of the no-load speed
// A limit as low as this harms nothing: the 2013 test of the torque limit raised it slowly from 0 under a hanging arm,
// which the limit of the arm's weight (8 %) held back all the time, and no servo tripped.
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
  const bool stands = std::abs(s.velocity_rad_s) * parameters.back_emf_vs_rad < kStandsBelow * parameters.supply_v;
  for_s_ = at_limit && stands ? for_s_ + dt_s : 0;
  // Half a period: sums of periods are not exact.
  tripped_ = tripped_ || for_s_ > parameters.overload_time_s - dt_s / 2;
}

}  // namespace darwinop::twin
