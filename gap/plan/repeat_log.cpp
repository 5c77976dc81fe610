// A log as an experiment.
#include <cmath>
#include <vector>

#include "core/conversions.hpp"
#include "gap/plan/commands.hpp"
#include "gap/plan/experiment_candidate.hpp"

namespace darwinop::gap {
namespace {

constexpr std::size_t kGoalsALine = 8;  // a file has lines that people read

/// Stretches of one goal, or of none.
struct Run {
  double goal;  // NaN: limp
  int rows;
};
std::vector<Run> runsOf(const Trajectory& log) {
  std::vector<Run> runs;
  std::size_t row = 0;
  for (double t = 0; t <= log.duration_s(); t += kPlannedRow) {
    while (row + 1 < log.rows() && log.time_s[row + 1] - log.time_s[0] <= t + 1e-6) ++row;
    const double goal = log.torque_on[row] != 0 ? log.goal_rad[row] : std::nan("");
    const bool same = !runs.empty() && (runs.back().goal == goal || (std::isnan(runs.back().goal) && std::isnan(goal)));
    if (same)
      ++runs.back().rows;
    else
      runs.push_back({goal, 1});
  }
  return runs;
}

double rounded(double value) {
  return std::round(value * 1e4) / 1e4;  // a tenth of a milliradian, a fifteenth of a tick
}

}  // namespace

experiments::Experiment again(const Trajectory& log, const ArmSetup& stand, const std::string& name) {
  experiments::Experiment made;
  made.name = made.file = name;
  made.title = "The commands of " + log.file + " once more";
  made.source = "darwinop gap plan";
  made.setup = stand.setup;
  made.record_joints = {stand.joint};
  experiments::Round& round = made.rounds.emplace_back();
  for (const Run& run : runsOf(log)) {
    const bool limp = std::isnan(run.goal);
    const bool goes_on = !round.phases.empty() && !limp &&
                         round.phases.back().torque == experiments::TorqueMode::kLimit &&
                         round.phases.back().goal.goals.size() < kGoalsALine;
    if (!goes_on) {
      experiments::Phase& phase = round.phases.emplace_back();
      phase.name = limp ? "limp" : "follow";
      phase.joints = {{stand.joint, 1}};
      phase.p_gain = log.p_register / kRegisterPerKp;
      if (log.speed_limit_rad_s > 0) phase.velocity = log.speed_limit_rad_s;
      if (limp) phase.torque = experiments::TorqueMode::kOff;
      if (!limp) phase.goal.shape = experiments::Shape::kSteps;
    }
    experiments::Phase& phase = round.phases.back();
    const double seconds = run.rows * kPlannedRow;
    phase.duration_s = rounded(phase.duration_s + seconds);
    if (limp) continue;
    phase.goal.goals.push_back(rounded(stand.hangs_at_rad + run.goal));
    phase.goal.every_s.push_back(rounded(seconds));
  }
  // It begins where the log began, and waits there.
  experiments::Phase& first = round.phases.front();
  if (log.goal_before_rad)
    made.setup.pose[index(stand.joint)] = rounded(stand.hangs_at_rad + *log.goal_before_rad);
  else if (first.torque == experiments::TorqueMode::kLimit)
    made.setup.pose[index(stand.joint)] = first.goal.goals.front();
  takeTimeFor(made.setup);
  return made;
}

}  // namespace darwinop::gap
