// Rows of a log and steps of a target are two clocks: commands come with the rows.
#include "gap/export/replay.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "gap/plant/bench/roll_out.hpp"
#include "gap/plant/row_state.hpp"
#include "gap/plant/write_instant.hpp"

namespace darwinop::gap {
namespace {

constexpr double kSameInstant = 1e-6;  // of a step, or of a firmware period

class Replay {
 public:
  Replay(const Trajectory& log, GoalOrder order, TargetJoint& joint, double step_s)
      : log_{log}, joint_{joint}, step_s_{step_s} {
    const std::optional<double> held = heldBefore(log, order);
    joint.reset(held.value_or(knownPosition(log, 0)));
    goal_rad_ = held.value_or(log.goal_rad[0]);
    torque_on_ = held.has_value() || log.torque_on[0] != 0;
    if (held)
      for (long i = std::lround(kHeldBefore / step_s); i > 0; --i) joint.step(true, *held);
  }

  void advanceTo(double time_s) {
    for (; static_cast<double>(steps_ + 1) <= time_s / step_s_ + kSameInstant; ++steps_)
      joint_.step(torque_on_, goal_rad_);
  }

  /// Between two steps the joint moves on at its velocity.
  double positionAt(double time_s) {
    advanceTo(time_s);
    return joint_.position_rad() + joint_.velocity_rad_s() * (time_s - static_cast<double>(steps_) * step_s_);
  }

  void command(std::size_t row) {
    goal_rad_ = log_.goal_rad[row];
    torque_on_ = log_.torque_on[row] != 0;
  }

 private:
  const Trajectory& log_;
  TargetJoint& joint_;
  const double step_s_;
  double goal_rad_ = 0;
  bool torque_on_ = false;
  long steps_ = 0;
};

/// When the firmware read the position that it answers with in this row, s after row 0: a period before the last of
/// its periods that had begun, as rollOut() has it.
double registeredAt(const Trajectory& log, std::size_t row, double period_s) {
  const double phase = log.is_phase_known ? 0 : kMeanPhase;
  const double periods = (log.time_s[row] - log.time_s[0] + log.read_s[row]) / period_s + phase;
  return std::max(0.0, (std::floor(periods + kSameInstant) - 1 - phase) * period_s);
}

}  // namespace

std::vector<double> replay(const Trajectory& log, GoalOrder order, TargetJoint& joint, double step_s,
                           const Hypothesis& hypothesis) {
  const double firmware_period_s = hypothesis.servo.firmware_period_s;
  Replay run{log, order, joint, step_s};
  std::vector<double> position(log.rows());
  for (std::size_t row = 0; row < log.rows(); ++row) {
    const double time_s = log.time_s[row] - log.time_s[0];
    if (log.isReadAfterWrite()) {
      const double written_s = time_s + log.written_s[row];
      const double registered_s = registeredAt(log, row, firmware_period_s);
      const bool is_older = registered_s < written_s;  // read by the firmware before the goal came
      if (is_older) position[row] = run.positionAt(registered_s);
      run.advanceTo(written_s);
      run.command(row);
      if (!is_older) position[row] = run.positionAt(registered_s);
    } else if (order == GoalOrder::kBeforeRead) {
      run.advanceTo(writtenAt(log, row, hypothesis.written_before_s));
      run.command(row);
      position[row] = run.positionAt(time_s);
    } else {
      position[row] = run.positionAt(time_s);
      run.command(row);
    }
  }
  return position;
}

}  // namespace darwinop::gap
