// Robot of a program that is not a controller: an experiment, a motion that is played.
#pragma once

#include <stdexcept>
#include <webots/Robot.hpp>

namespace darwinop::webots_api {

/// What the program states about its session. Changes messages only, nothing of safety.
struct ToolSession {
  bool trunk_is_held = false;  // by a stand: a tilted one has not fallen
};

/// Thrown after the loop has begun, while the robot was made ready: it may have moved. All other errors of a start are
/// thrown before.
class EndedBeforeReady : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// As webots::Robot, but errors are thrown, and what only the author of a controller can use is not printed.
class ToolRobot : public webots::Robot {
 public:
  /// Throws EndedBeforeReady, or another std::runtime_error.
  explicit ToolRobot(const ToolSession& session = {});
};

}  // namespace darwinop::webots_api
