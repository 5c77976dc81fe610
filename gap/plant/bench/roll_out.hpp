// Closed-loop simulation of a log: the same commands at the same times, on a hypothesis.
#pragma once

#include <cstdint>
#include <vector>

#include "gap/plant/hypothesis.hpp"

namespace darwinop::gap {

/// What the simulated servo reports, one value for each row of the log. No quantisation unless a Disturbance asks.
struct Trace {
  std::vector<double> position_rad;    // of the encoder
  std::vector<double> velocity_rad_s;  // of the arm; true
  std::vector<double> load;            // as the servo reports it, -1 to 1
  std::vector<double> supply_v;        // at the servo
};

/// Run-to-run noise of a bench: torque, supply and encoder.
struct Disturbance {
  std::uint64_t seed = 0;
  double torque_nm = 0.002, torque_time_s = 0.02;  // standard deviation and correlation time
  double supply_v = 0.03, supply_time_s = 0.05;
  double encoder_ticks = 0.3;  // before rounding
};

/// Without disturbance the encoder is exact, so that the result is a smooth function of the hypothesis. With one,
/// registers round as the real ones do.
struct RollOutOptions {
  const Disturbance* disturbance = nullptr;
  // Mechanical steps in a period of the firmware. 0: as many as the law needs, and a firmware faster than 0.5 ms is
  // simulated as one of at most that, whose encoder looks half of the difference ahead.
  int steps_per_period = 0;
};

/// Reuses the memory of `trace`. May run in several threads at once, each with a trace of its own. Throws
/// std::runtime_error for a hypothesis that cannot be (no inertia left).
void rollOut(const Case& given, std::size_t log, const Hypothesis& hypothesis, const RollOutOptions& options,
             Trace& trace);

}  // namespace darwinop::gap
