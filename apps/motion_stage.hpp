// A robot that plays movements in sequence, for `darwinop motion play`.
#pragma once

#include <DARwInOPMotionManager.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <webots/Robot.hpp>
#include <webots/utils/Motion.hpp>

#include "core/text/number_text.hpp"
#include "managers/motion_watch/motion_watch.hpp"
#include "managers/motion_watch/posture.hpp"
#include "webots/robot_impl.hpp"

namespace darwinop::motion {

/// Movements keep the robot's time, also in a loop slower than its step.
class PlayStage {
 public:
  /// `robot` must outlive it.
  explicit PlayStage(webots::Robot& robot) : robot_{robot} {}

  /// Returns false if the robot or the user has ended it.
  bool page(const std::string& file, int number) {
    if (!manager_) manager_ = std::make_unique<managers::DARwInOPMotionManager>(&robot_, file);
    manager_->playPage(number, false);
    if (!manager_->isMotionPlaying()) return false;  // already reported
    while (manager_->isMotionPlaying())
      if (!step()) return false;                      // plays it
    return sensors().safety.state == State::kDriven;  // otherwise it ended early, which is reported
  }
  bool motion(const std::string& file) {
    webots::Motion motion{file};
    motion.play();
    do
      if (!step()) return false;
    while (!motion.isOver());
    return true;
  }
  bool waitUntilSettled() {
    constexpr double kSettle = 1.0;  // s after the last goal, for the body to settle
    for (const double end = robot_.getTime() + kSettle; robot_.getTime() < end;)
      if (!step()) return false;
    return true;
  }

  void printSummary(double seconds) const {
    std::cout << "played for " << text::fixedText(seconds, 1) << " s; greatest distance from the goal, greatest load:\n"
              << watch_.jointsText() << watch_.faultsText() << "the robot " << textOf(postureOf(sensors()))
              << std::endl;
  }
  [[nodiscard]] double seconds() const { return robot_.getTime() - began_; }

 private:
  bool step() {
    if (robot_.step(step_ms_) == -1) return false;
    watch_.update(sensors(), seconds());
    return true;
  }
  static const Sensors& sensors() { return webots_api::currentRobot()->session().sensors(); }

  webots::Robot& robot_;
  const int step_ms_ = static_cast<int>(robot_.getBasicTimeStep());
  const double began_ = robot_.getTime();
  std::unique_ptr<managers::DARwInOPMotionManager> manager_;
  MotionWatch watch_;
};

}  // namespace darwinop::motion
