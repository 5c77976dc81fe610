// What an experiment will do, worked out before anything moves: where each joint may go, how fast, how long.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "experiments/format/experiment.hpp"
#include "safety/config.hpp"

namespace darwinop::experiments {

using Ranges = std::array<safety::JointRange, kJoints>;

/// Goals of one joint, in one phase or in all of them.
struct JointPlan {
  Joint joint{};
  double low = 0, high = 0;  // rad
  double fastest = 0;        // rad/s, of the goal; where it jumps, the speed limit
  bool loose = false;        // without a goal for a while: weight or a given torque moves it
};

struct PhasePlan {
  const Phase* phase;
  std::vector<JointPlan> joints;
};

struct RoundPlan {
  std::string label;
  std::vector<PhasePlan> phases;
};

struct Plan {
  std::vector<JointPlan> setup;  // joints that leave the start pose: from low to high, whichever is greater
  std::vector<RoundPlan> rounds;
  std::vector<JointPlan> moved;                  // by phases; all of them taken together
  double setup_s = 0, phases_s = 0, back_s = 0;  // at most
  bool on_feet = false, falls = false;
  bool legs = false;  // a phase moves joints of the legs, or lets them go

  [[nodiscard]] double seconds() const { return setup_s + phases_s + back_s; }
};

// The ways to the first pose and back are slow: half of what the runtime takes for a slow start.
inline constexpr double kSlow = 0.6;       // rad/s, at the steepest, on the way back
inline constexpr double kSetupMost = 1.2;  // rad/s, the most that a file may ask for in [setup]

/// Seconds for a smooth way of that many rad at kSlow.
double slowTime(double way_rad);

/// Checks everything. Throws std::runtime_error, "FILE, line N: what is wrong, value and limit". `experiment` must
/// outlive the plan.
Plan makePlan(const Experiment& experiment, const Ranges& ranges);

/// For people, several lines: what moves, from where to where, how fast, how long, whether the robot may fall.
std::string planText(const Experiment& experiment, const Plan& plan);
/// "key: value" lines for the head of the recording: which experiment, which joints and sensors matter.
std::string recordNotes(const Experiment& experiment);
/// One line: "Neck -1.571 to 1.571 rad".
std::string movedText(const Plan& plan);

}  // namespace darwinop::experiments
