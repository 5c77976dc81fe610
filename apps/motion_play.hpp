// `darwinop motion play`: plays pages or a .motion file on the twin, the virtual robot or a robot.
#pragma once

#include <string>
#include <vector>

namespace darwinop::motion {

struct PlayRequest {
  std::string file;        // pages, .motion, or "own"
  std::vector<int> pages;  // in this order; empty for a .motion file
  std::string robot;       // empty: DARWINOP_ROBOT, else the twin
  std::string record;      // empty: no recording
  int period_ms = 0;       // 0: default
  bool yes = false;        // do not ask before moving a real robot
};

/// Returns the exit code. Throws std::runtime_error before anything moves, webots_api::EndedBeforeReady also after
/// that.
int play(PlayRequest request);

}  // namespace darwinop::motion
