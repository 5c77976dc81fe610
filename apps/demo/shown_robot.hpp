// A robot of the physics twin in this process, in simulated time, and a picture of all that it does.
#pragma once

#include <chrono>
#include <memory>
#include <webots/Robot.hpp>

#include "twin/view/screen.hpp"
#include "twin/view/watched_body.hpp"

namespace darwinop::demo {

/// As fast as the machine allows before a film; in a window no faster than real time. One at a time in a process.
class ShownRobot final : public webots::Robot {
 public:
  /// Stands ready in its start pose: time 0 of the film. Throws NoDisplay, NoGraphics, std::runtime_error.
  explicit ShownRobot(const twin::ShowOptions& options);

  /// -1, too, when the film is long enough or its window is closed. Throws std::runtime_error: the film cannot be
  /// written.
  int step(int ms) override;
  /// Writes the film to its end and says where it is. Throws std::runtime_error when it is not whole.
  void finish();

  [[nodiscard]] const twin::RobotBody& body() const { return watched_->robot(); }

 private:
  struct Parts;
  ShownRobot(const twin::ShowOptions& options, Parts parts);
  void draw();

  twin::WatchedBody* watched_;  // the robot owns it
  std::unique_ptr<twin::Screen> screen_;
  bool film_;
  double seconds_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace darwinop::demo
