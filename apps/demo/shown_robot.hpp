// A robot of the twin in this process, in simulated time, with a window or film of it.
#pragma once

#include <chrono>
#include <memory>
#include <webots/Robot.hpp>

#include "twin/view/screen.hpp"
#include "twin/view/watched_body.hpp"

namespace darwinop::demo {

/// As fast as possible for a film; at most real time in a window. One per process.
class ShownRobot final : public webots::Robot {
 public:
  /// Returns after the takeover, with the robot in its start pose: time 0 of the film. Throws NoDisplay, NoGraphics,
  /// std::runtime_error.
  explicit ShownRobot(const twin::ShowOptions& options);

  /// Also returns -1 when the film has its length or the window is closed. Throws std::runtime_error if the film cannot
  /// be written.
  int step(int ms) override;
  /// Completes the film and prints its path. Throws std::runtime_error if it is incomplete.
  void finish();

  [[nodiscard]] const twin::RobotBody& body() const { return watched_->robot(); }

 private:
  struct Parts;
  ShownRobot(const twin::ShowOptions& options, Parts parts);
  void draw();

  twin::WatchedBody* watched_;  // owned by the robot
  std::unique_ptr<twin::ViewOutput> screen_;
  bool film_;
  double seconds_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace darwinop::demo
