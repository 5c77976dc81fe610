// A case before it is simulated: model, commands, temperature.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "gap/case/case.hpp"

namespace darwinop::gap {

/// Kinds of model that a case starts from.
enum class Baseline : std::uint8_t {
  kFrictionless,  // V0: law voltage_p, viscous friction only
  kFriction,      // CV: law voltage_p, dry and viscous friction
  kSpeed,         // W: law speed_p, dry and viscous friction
  kFine,          // F: as CV, of a family whose firmware acts every 0.1 ms on an encoder without ticks
};
/// "V0", "CV", "W", "F".
std::string_view nameOf(Baseline baseline);

/// Over a session.
struct WarmUp {
  double start_c = twin::kRoomC, rise_k = 22, time_s = 40;
  [[nodiscard]] double at(double session_s) const;
};

struct CasePlan {
  Case given;  // its logs have time, goal and torque; measured columns are empty except for the temperature
  WarmUp warmth;
};

/// Numbers around those of an MX-28, ten logs as benches of this servo make them in a session of 86 s.
CasePlan drawnPlan(const std::string& name, Baseline baseline, std::uint64_t seed);
/// Bench and commands of an existing case.
CasePlan planLike(const Case& other, const std::string& name);

}  // namespace darwinop::gap
