// A candidate for the next experiment, and what it requires besides the robot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/servo_limits.hpp"
#include "experiments/format/experiment.hpp"
#include "gap/case/case.hpp"
#include "gap/plan/arm_setup.hpp"

namespace darwinop::gap {

struct ExperimentCandidate {
  experiments::Experiment experiment;  // of the stand's joint alone
  double payload_kg = 0;               // at the end of the arm
  std::string prepare;                 // "hang 100 g more to the arm"; empty: nothing
  double prepare_s = 0;                // of a person's time
  double temp_c = twin::kRoomC;        // of the servo
  double session_start_s = 0;
};

/// Conditions under which the logs of a case were recorded; a planned log is likely to have the same.
struct Circumstances {
  double payload_kg = 0;                                // that most logs have
  double cold_c = twin::kRoomC, warm_c = twin::kRoomC;  // least and greatest temperature seen
  double session_end_s = 0;
  double p_gain = kDefaultPGain;  // the middle one of the logs for fits, as experiments count
};
Circumstances circumstancesOf(const Case& given);

/// The delivered experiments that move one joint, moved to `stand`; then the bench experiments; then some with
/// another payload, and the first log of the case once more. What cannot be read is left out.
std::vector<ExperimentCandidate> candidatesFor(const Case& given, const ArmSetup& stand);
/// Those without the delivered ones.
std::vector<ExperimentCandidate> benchCandidates(const Case& given, const ArmSetup& stand);

/// The same experiment by another joint, at the same angles of the arm. Nothing: it moves several joints, or falls.
std::optional<experiments::Experiment> movedTo(const ArmSetup& stand, experiments::Experiment experiment);

/// The commands of a log as an experiment: steps from goal to goal, limp where the log was.
experiments::Experiment again(const Trajectory& log, const ArmSetup& stand, const std::string& name);

}  // namespace darwinop::gap
