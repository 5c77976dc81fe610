// Goals that jump, and what a joint makes of them.
#pragma once

#include <cstddef>
#include <vector>

#include "experiments/logs/plot/traces.hpp"

namespace darwinop::plot {

/// From the row in which a new goal stands to the row in which it changes again.
struct Step {
  std::size_t begin = 0, end = 0;
  double from = 0, to = 0;  // rad
};

/// The jumps of at least 0.8 of the greatest one: the way to the first goal is shorter, and is none.
[[nodiscard]] std::vector<Step> largeSteps(const JointColumns& joint, std::size_t from_row);

/// Seconds until the joint is within 0.05 rad (3 degrees) of the goal and stays there; NaN: it does not arrive.
[[nodiscard]] double arrival(const logs::Log& log, const JointColumns& joint, const Step& step);

/// Rows from begin to before end.
struct Stretch {
  std::size_t begin = 0, end = 0;
};

/// Where the goal slides one way for two seconds or more at less than 0.2 rad/s: slow enough for what is measured to
/// be at rest. Without the ways between poses, which are faster or less than half as long as the longest of these.
[[nodiscard]] std::vector<Stretch> slowStretches(const logs::Log& log, const JointColumns& joint);

/// Where the joint has no torque.
[[nodiscard]] std::vector<Stretch> limpStretches(const JointColumns& joint, std::size_t from_row);

/// Where the torque limit slides furthest: without jumps of more than 0.3 N m from one row to the next.
[[nodiscard]] Stretch torqueSlope(const JointColumns& joint);

}  // namespace darwinop::plot
