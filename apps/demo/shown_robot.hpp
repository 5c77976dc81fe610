// A twin robot in this process in simulated time, with a picture of its motion.
#pragma once

#include <chrono>
#include <memory>
#include <webots/Robot.hpp>

#include "twin/view/screen.hpp"
#include "twin/view/watched_body.hpp"

namespace darwinop::demo {

/// Runs as fast as possible for a film, at most in real time for a window. One per process.
class ShownRobot final : public webots::Robot {
 public:
  /// Moves to the start pose: time 0 of the film. Throws NoDisplay, NoGraphics, std::runtime_error.
  explicit ShownRobot(const twin::ShowOptions& options);

  /// Also returns -1 when the film is complete or its window is closed. Throws std::runtime_error if the film cannot be written.
  int step(int ms) override;
  /// Completes the film and prints its name. Throws std::runtime_error if it is incomplete.
  void finish();

  [[nodiscard]] const twin::RobotBody& body() const { return watched_->robot(); }

 private:
  struct Parts;
  ShownRobot(const twin::ShowOptions& options, Parts parts);
  void draw();

  twin::WatchedBody* watched_;  // owned by the robot
  std::unique_ptr<twin::Screen> screen_;
  bool film_;
  double seconds_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace darwinop::demo
