// A small bench in memory: three short logs, simulated by the twin with the noise of a bench.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "gap/plant/bench/roll_out.hpp"
#include "gap/plants.hpp"
#include "twin/effects/catalogue.hpp"

namespace darwinop::gap {

inline constexpr double kRow = 0.016;  // s

inline Trajectory commanded(const std::string& kind, double seconds, double p_register, double payload_kg,
                            double (*goal)(double), double torque_off_s = 1e9) {
  Trajectory log;
  log.file = kind + ".csv";
  log.kind = kind;
  log.p_register = p_register;
  log.payload_kg = payload_kg;
  for (int row = 0; row * kRow < seconds; ++row) {
    const double t = row * kRow;
    log.time_s.push_back(t);
    log.goal_rad.push_back(goal(t));
    log.torque_on.push_back(t < torque_off_s ? 1 : 0);
    log.lines.push_back(static_cast<std::uint32_t>(row + 2));
  }
  const std::vector<double> unknown(log.rows(), std::numeric_limits<double>::quiet_NaN());
  log.position_rad = log.speed_rad_s = log.volt_v = log.load = unknown;
  log.temp_c.assign(log.rows(), 25);
  return log;
}

/// A servo by its data sheet with a little friction, an arm with a weight; nothing measured yet.
inline Case smallBench() {
  Case bench;
  bench.name = "small";
  bench.model.servo.back_emf_vs_rad = bench.model.servo.kt_nm_a;
  bench.pendulum = {.payload_kg = 0, .arm_mass_kg = 0.03, .length_m = 0.14};
  bench.model.effects.push_back({.info = twin::findEffect("viscous"), .values = {0.015}, .joint = {}});
  bench.priors = {{"kt", 0.02}, {"resistance", 0.04}, {"armature", 0.1}, {"payload", 0.01}, {"length", 0.01}};
  bench.logs.push_back(commanded("steps", 4, 16, 0.3, [](double t) {
    return t < 0.8 ? 0.0 : t < 2 ? 0.9 : t < 3 ? -0.4 : 0.2;
  }));
  bench.logs.push_back(
      commanded("triangle", 5, 16, 0.3, [](double t) { return 1.2 - std::abs(std::fmod(t, 5) - 2.5) * 0.9; }));
  bench.logs.push_back(commanded(
      "release", 4, 16, 0.3, [](double) { return 1.2; }, 0.5));
  bench.logs.push_back(
      commanded("kept", 4, 12, 0.4, [](double t) { return 0.8 * std::sin(2 * t) + 0.2 * std::sin(9 * t); }));
  bench.logs.back().held_out = true;
  return bench;
}

/// The logs of a bench that has this hypothesis.
inline Case measured(Case bench, const Hypothesis& truth, std::uint64_t seed) {
  Trace trace;
  for (std::size_t i = 0; i < bench.logs.size(); ++i) {
    Disturbance disturbance;
    disturbance.seed = seed * 100 + i;
    rollOut(bench, i, truth, {.disturbance = &disturbance, .steps_per_period = 5}, trace);
    bench.logs[i].position_rad = trace[kPositionSignal];
    bench.logs[i].load = trace[kLoadSignal];
    for (double& load : bench.logs[i].load) load = std::round(load * 1'000) / 1'000;
  }
  return bench;
}

/// The bench's own model with one effect more.
inline Hypothesis withEffect(const Case& bench, std::string_view id, std::string_view key, double value) {
  Hypothesis truth = baselineOf(bench);
  valueOf(truth.with(*twin::findEffect(id)), key) = value;
  return truth;
}

}  // namespace darwinop::gap
