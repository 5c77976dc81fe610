// `darwinop experiment run`: runs an experiment on the twin, the virtual robot or a robot.
#pragma once

#include <string>

namespace darwinop::experiments {

struct ExperimentRequest {
  std::string experiment;  // name or file
  std::string robot;       // empty: DARWINOP_ROBOT, else the first one found
  std::string record;      // empty: a name with date and robot
  int period_ms = 0;       // 0: default
  bool yes = false;        // do not ask before moving a real robot
  bool no_record = false;
};

// Exit statuses, docs/experiments.md.
inline constexpr int kExitDone = 0, kExitEnded = 1, kExitWrong = 2, kExitNeedsYes = 3, kExitStopped = 130;

/// Throws std::runtime_error before anything moves.
int run(ExperimentRequest a);

}  // namespace darwinop::experiments
