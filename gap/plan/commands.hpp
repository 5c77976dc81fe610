// The commands of an experiment as logs without measurements, for prediction.
#pragma once

#include <vector>

#include "gap/plan/experiment_candidate.hpp"

namespace darwinop::gap {

inline constexpr double kPlannedRow = 0.016;  // s, of the host

/// A part of a round with one P gain and one speed limit, as a log has.
struct Stretch {
  Trajectory log;
  double begins_s = 0;  // of its first row within the round
};

/// Throws std::runtime_error, a sentence, for what cannot be predicted: a torque command, an end that depends on the
/// joint's motion.
std::vector<Stretch> commandsOf(const ExperimentCandidate& candidate, const experiments::Round& round,
                                const ArmSetup& stand);

/// `given` with these logs in place of its own. Goals are written after the read: each log begins held.
Case planned(const Case& given, const std::vector<Stretch>& stretches);

}  // namespace darwinop::gap
