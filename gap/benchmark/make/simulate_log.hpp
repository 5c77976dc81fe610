// Simulates the measured columns of a log with the true bench, not the model's.
#pragma once

#include <vector>

#include "gap/benchmark/make/case_plan.hpp"
#include "gap/benchmark/make/outside.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {

/// The true bench.
struct Truth {
  Hypothesis bench;
  std::vector<OutsideSetting> outside;
};

/// Fills the measured columns of one log of the plan, in the resolution of the registers. `disturbance` null: without
/// noise and rounding; the firmware still counts in steps of the encoder. A rigid gear runs on RigidArm; one with play
/// or a spring on twin::Bench, with a quarter of the time step of a fit.
void measure(const CasePlan& plan, const Truth& truth, const Disturbance* disturbance, Trajectory& log);

}  // namespace darwinop::gap
