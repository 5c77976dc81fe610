// `darwinop experiment run`: runs an experiment on the twin, the virtual robot or a robot.
#pragma once

#include <string>

namespace darwinop::experiments {

inline constexpr const char* kNamesAbsentJoint =
    " is absent according to robot.ini; take another joint, or correct [Robot] absent";  // after file and joint
inline constexpr const char* kStoppedOnRequest = "stopped on request";
inline constexpr const char* kRecordedUntilThen = "; the recording contains the data until then";

struct ExperimentRequest {
  std::string experiment;  // name or file
  std::string robot;       // empty: DARWINOP_ROBOT, else the first one found
  std::string record;      // empty: a name with date and robot
  int period_ms = 0;       // 0: default
  bool yes = false;        // do not ask before moving a real robot
  bool no_record = false;
  bool allows_clamped = false;  // clamped goals are reported only
};

/// Returns the exit code. Throws std::runtime_error before anything moves, webots_api::EndedBeforeReady also after
/// that.
int run(ExperimentRequest a);

}  // namespace darwinop::experiments
