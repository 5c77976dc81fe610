// A bench whose logs are roll-outs of its own model, with the effect that a test adds.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "core/units.hpp"
#include "gap/localize/simulated_repeats.hpp"
#include "gap/plant/bench/roll_out.hpp"
#include "gap/plants.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {

struct Hidden {
  std::string_view effect;  // empty: nothing
  std::vector<double> values;
};

inline Trajectory commandsOf(const std::string& file, double seconds, const std::function<double(double)>& goal_rad,
                             double limp_from_s = 1e9) {
  constexpr double kTick = 2 * kPi / 4096, kRowTime = 0.016;
  Trajectory log;
  log.file = file;
  log.kind = file;
  log.p_register = 24;
  log.payload_kg = 0.3;
  for (int row = 0; row * kRowTime <= seconds; ++row) {
    const double t = row * kRowTime;
    log.time_s.push_back(t);
    log.goal_rad.push_back(std::round(goal_rad(t) / kTick) * kTick);
    log.torque_on.push_back(t < limp_from_s ? 1 : 0);
    log.lines.push_back(static_cast<std::uint32_t>(row) + 2);
  }
  log.position_rad.resize(log.rows());
  log.speed_rad_s = log.load = log.volt_v = std::vector<double>(log.rows(), 0.0);
  log.temp_c.resize(log.rows(), 30);
  return log;
}

/// Steps, a sine, and a release; the last repeats the first.
inline Case commandedCase(twin::Law law = twin::Law::kVoltageP) {
  Case made;
  made.name = "made";
  made.model.servo.law = law;
  made.model.servo.firmware_period_s = 0.002;  // half the work
  made.model.servo.speed_gain_per_kp_1_s = 0.3;
  made.model.servo.speed_max_rad_s = 5.8;
  made.model.servo.back_emf_vs_rad = made.model.servo.kt_nm_a;
  made.model.effects = {{twin::findEffect("coulomb"), {0.08}, {}}, {twin::findEffect("viscous"), {0.01}, {}}};
  made.pendulum = {.payload_kg = 0.3, .arm_mass_kg = 0.04, .length_m = 0.15};
  made.priors = {{"payload", 0.01}, {"coulomb.friction", 0.1}};
  made.datasheet = Datasheet{};
  const auto steps = [](double t) { return t < 0.4 ? -0.5 : t < 1.2 ? 0.7 : t < 1.8 ? 0.4 : -0.6; };
  made.logs.push_back(commandsOf("steps.csv", 2.6, steps));
  made.logs.push_back(commandsOf("sine.csv", 2.6, [](double t) { return 0.6 * std::sin(2 * kPi * 0.6 * t); }));
  made.logs.push_back(commandsOf(
      "release.csv", 2.0, [](double t) { return t < 0.3 ? 0.3 : 0.9; }, 0.8));
  made.logs.push_back(commandsOf("again.csv", 2.6, steps));
  made.logs.back().repeat_of = 0;
  for (std::size_t i = 0; i < made.logs.size(); ++i) made.logs[i].session_start_s = 5.0 * static_cast<double>(i);
  return made;
}

/// The case as it would have been measured on a bench with this effect, and noise.
inline Case measuredCase(const Hidden& hidden, twin::Law law = twin::Law::kVoltageP, std::uint64_t seed = 77,
                         Disturbance disturbance = {}) {
  Case made = commandedCase(law);
  Hypothesis truth = baselineOf(made);
  if (!hidden.effect.empty()) truth.with(*twin::findEffect(hidden.effect)).values = hidden.values;
  for (std::size_t i = 0; i < made.logs.size(); ++i) {
    disturbance.seed = seed * 100 + i;
    Trace trace;
    rollOut(made, i, truth, {.disturbance = &disturbance}, trace);
    made.logs[i] = asReported(made.logs[i], trace, truth.servo.ticks_per_rev, disturbance.seed);
  }
  return made;
}

}  // namespace darwinop::gap
