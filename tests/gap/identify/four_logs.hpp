// Four logs of a servo that a manual describes, in memory.
#pragma once

#include <cmath>

#include "gap/small_case.hpp"

namespace darwinop::gap {

inline double slowSine(double t) {
  return 0.4 * std::sin(1.5 * t);
}
inline double triangle(double t) {
  return 1.2 - std::abs(std::fmod(t, 5) - 2.5) * 0.9;
}

/// Two motions at two gains, all fitted; nothing measured yet.
inline Case fourLogs() {
  Case bench = smallBench();
  bench.priors = {{"kt", 0.15}, {"resistance", 0.25}, {"armature", 0.5}, {"payload", 0.02}, {"length", 0.02}};
  bench.logs.clear();
  for (const double p_register : {16.0, 32.0})
    for (auto* const goal : {&slowSine, &triangle}) bench.logs.push_back(commanded("motion", 5, p_register, 0.4, goal));
  return bench;
}

inline NoiseOptions fewRuns() {
  NoiseOptions options;
  options.runs = 8;
  return options;
}

}  // namespace darwinop::gap
