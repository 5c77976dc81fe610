// What tests of the servo and of the single-joint bench have in common: effects by name, drives, and a clock.
#pragma once

#include <initializer_list>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "core/conversions.hpp"
#include "twin/bench/bench.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::twin::testing {

using Effects = std::vector<std::unique_ptr<Effect>>;

/// The effect `id`: its first parameters as given, the rest neutral.
inline std::unique_ptr<Effect> effect(std::string_view id, std::initializer_list<double> first) {
  const EffectInfo* info = findEffect(id);
  std::vector<double> values{first};
  for (std::size_t i = values.size(); i < info->parameters.size(); ++i) values.push_back(info->parameters[i].neutral);
  return info->make(values);
}

inline Effects friction(double coulomb_nm, double viscous_nms_rad) {
  Effects effects;
  effects.push_back(effect("coulomb", {coulomb_nm}));
  effects.push_back(effect("viscous", {viscous_nms_rad}));
  return effects;
}

inline Effects with(std::unique_ptr<Effect> one, Effects others = {}) {
  others.push_back(std::move(one));
  return others;
}

/// No limit of speed, full torque.
inline ServoDrive driveTo(double goal_rad, double kp = 4) {
  return {.torque_on = true,
          .goal_rad = goal_rad,
          .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
          .torque_limit = 1,
          .p_gain = kp};
}

inline const ServoDrive kLimp{};

inline void run(Bench& bench, const ServoDrive& drive, double seconds) {
  const double until = bench.time_s() + seconds - 0.0005;
  while (bench.time_s() < until) bench.step(drive);
}

/// Friction and no-load speed of docs/twin/servo.md.
inline constexpr double kCoulomb = 0.025, kViscous = 0.002;
inline constexpr double kNoLoad = 55 * 2 * kPi / 60;
inline ServoParameters mx28() {
  ServoParameters p;
  p.back_emf_vs_rad = (12 - (kCoulomb + kViscous * kNoLoad) * p.resistance_ohm / p.kt_nm_a) / kNoLoad;
  return p;
}
/// The robot's arm, about, on one joint: 0.2 N m when it stands out sideways.
inline constexpr Pendulum kArm{.payload_kg = 0.2, .arm_mass_kg = 0.06, .length_m = 0.0887};

}  // namespace darwinop::twin::testing
