// Simulates the measured columns of a log with the true bench, not the model's.
#pragma once

#include <vector>

#include "gap/benchmark/make/case_plan.hpp"
#include "gap/benchmark/make/outside.hpp"
#include "gap/plant/bench/roll_out.hpp"

namespace darwinop::gap {

/// What the bench really is.
struct Truth {
  Hypothesis bench;
  std::vector<OutsideSetting> outside;
};

/// Fills the measured columns of one log of the plan, as registers tell them. `disturbance` null: a quiet bench, whose
/// columns are not rounded; its firmware still counts in steps of the encoder. A rigid gear runs on RigidArm; one with
/// play or a spring on twin::Bench, four times as finely as a finder runs it.
void measure(const Plan& plan, const Truth& truth, const Disturbance* disturbance, Trajectory& log);

}  // namespace darwinop::gap
