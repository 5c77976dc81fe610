// What the tests of the effects share: effects by name, a servo that has them, and a run that shows most of them.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "twin/bench/bench.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::twin {

/// An effect, and those of its parameters that are not neutral.
struct Chosen {
  std::string_view id;
  std::vector<std::pair<std::string_view, double>> values;
};

inline std::vector<double> valuesOf(const EffectInfo& info, double Parameter::*which) {
  std::vector<double> values;
  for (const Parameter& parameter : info.parameters) values.push_back(parameter.*which);
  return values;
}

inline std::vector<double> valuesOf(const EffectInfo& info, const Chosen& chosen) {
  std::vector<double> values = valuesOf(info, &Parameter::neutral);
  for (const auto& [key, value] : chosen.values) {
    const auto found = std::ranges::find(info.parameters, key, &Parameter::key);
    if (found == info.parameters.end())
      throw std::runtime_error(std::string{info.id} + " has no parameter " + std::string{key});
    values[static_cast<std::size_t>(found - info.parameters.begin())] = value;
  }
  return values;
}

using Effects = std::vector<std::unique_ptr<Effect>>;

/// In the order of the catalogue, as a model file's are.
inline Effects effectsOf(const std::vector<Chosen>& choice) {
  Effects effects;
  for (const EffectInfo* info : catalogue())
    for (const Chosen& chosen : choice)
      if (chosen.id == info->id) effects.push_back(info->make(valuesOf(*info, chosen)));
  if (effects.size() != choice.size()) throw std::runtime_error("a chosen effect is not in the catalogue");
  return effects;
}

inline Servo servoWith(const std::vector<Chosen>& choice, const ServoParameters& parameters = {}) {
  return Servo{parameters, effectsOf(choice)};
}

inline ServoDrive driveTo(double goal_rad) {
  return {.torque_on = true,
          .goal_rad = goal_rad,
          .speed_limit_rad_s = std::numeric_limits<double>::infinity(),
          .torque_limit = 1};
}

/// An arm that needs 0.49 N m to stand out sideways, a fifth of what the servo has.
inline constexpr Pendulum kArm{.payload_kg = 0.3, .arm_mass_kg = 0.04, .length_m = 0.155};

inline void runFor(Bench& bench, double seconds, const ServoDrive& drive) {
  const double end = bench.time_s() + seconds - bench.servo().parameters().firmware_period_s / 2;
  while (bench.time_s() < end) bench.step(drive);
}

}  // namespace darwinop::twin
