// A bench in memory whose servo is roughly known: by its manual.
#pragma once

#include <cmath>
#include <utility>

#include "gap/small_case.hpp"

namespace darwinop::gap {

inline double wave(double t) {
  return 0.9 * std::sin(2 * t) + 0.4 * std::sin(5 * t);
}
inline double lift(double t) {
  return t < 0.5 ? 0 : 1.3;
}
inline double slowWave(double t) {
  return 1.5 + 0.12 * std::sin(1.5 * t);
}
inline double quickWave(double t) {
  return 1.5 + 0.1 * std::sin(4 * t);
}
inline double stairs(double t) {
  return std::fmod(t, 2) < 1 ? 0.8 : -0.5;
}

/// By its manual: no friction, and a motor whose numbers may be far off.
inline Case manualBench() {
  Case bench = smallBench();
  bench.model.effects.clear();
  bench.priors = {{"kt", 0.15}, {"resistance", 0.25}, {"armature", 0.5}, {"payload", 0.02}, {"length", 0.02}};
  bench.logs.clear();
  for (const double p_register : {16.0, 32.0, 64.0}) {
    for (auto* const goal : {&wave, &stairs}) {
      bench.logs.push_back(commanded("wave", 4, p_register, 0.4, goal));
      bench.logs.back().held_out = p_register == 64;
    }
    bench.logs.push_back(commanded("lift", 4, p_register, 0.4, &lift, 2));
    bench.logs.back().held_out = p_register == 64;
  }
  return bench;
}

inline Hypothesis realServo(const Case& bench) {
  Hypothesis truth = withEffect(bench, "kp_scale", "scale", 0.5);
  valueOf(truth.with(*twin::findEffect("coulomb")), "friction") = 0.03;
  valueOf(truth.with(*twin::findEffect("viscous")), "damping") = 0.02;
  valueOf(truth.with(*twin::findEffect("load_dependent_friction")), "share") = 0.15;
  valueOf(truth.with(*twin::findEffect("encoder_offset")), "offset") = -0.03;
  truth.servo.resistance_ohm *= 1.15;
  return truth;
}

inline Case measuredIn(Disturbance wind, Case bench, const Hypothesis& truth) {
  Trace trace;
  for (std::size_t i = 0; i < bench.logs.size(); ++i) {
    wind.seed = 700 + i;  // gusts of 1 draw in 3 hide the offset of the encoder
    rollOut(bench, i, truth, {.disturbance = &wind, .steps_per_period = 5}, trace);
    bench.logs[i].position_rad = trace[kPositionSignal];
    bench.logs[i].load = trace[kLoadSignal];
    bench.logs[i].volt_v = trace[kSupplySignal];
  }
  return bench;
}

}  // namespace darwinop::gap
