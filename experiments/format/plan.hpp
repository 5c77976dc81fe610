// Plan of an experiment: range, speed and duration of every joint, computed and checked before a run.
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
  double fastest = 0;        // rad/s, of the goal; the speed limit if the goal jumps
  bool loose = false;        // temporarily without a goal: moved by gravity or a commanded torque
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
  std::vector<JointPlan> setup;  // joints that leave the start pose: from low to high, in either order
  std::vector<RoundPlan> rounds;
  std::vector<JointPlan> moved;                  // by phases; union over all phases
  double setup_s = 0, phases_s = 0, back_s = 0;  // maximum
  bool is_clamped = false, on_feet = false, falls = false;
  bool legs = false;  // a phase moves leg joints or turns their torque off

  [[nodiscard]] double seconds() const { return setup_s + phases_s + back_s; }
};

// Motions to the setup pose and back are slow: half of the runtime's takeover speed.
inline constexpr double kSlow = 0.6;       // rad/s, peak speed of the return
inline constexpr double kSetupMost = 1.2;  // rad/s, maximum in [setup]

/// Duration of a smooth motion over this distance at kSlow, s.
double slowTime(double distance_rad);

/// Throws std::runtime_error, "FILE, line N: problem, value and limit". `experiment` must outlive the plan.
Plan makePlan(const Experiment& experiment, const Ranges& ranges);

/// Multi-line description for users: joints, ranges, speeds, durations, whether the robot may fall.
std::string planText(const Experiment& experiment, const Plan& plan);
/// "key: value" lines for the header of the recording: experiment, relevant joints and sensors.
std::string recordNotes(const Experiment& experiment);
/// One line: "Neck -1.571 to 1.571 rad".
std::string movedText(const Plan& plan);

}  // namespace darwinop::experiments
