// Computes each cycle's commands from goals, walk and motion pages. Pure: no clock, no thread.
#pragma once

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "managers/body_player/following.hpp"
#include "managers/body_player/page_player.hpp"
#include "managers/body_player/walk_player.hpp"
#include "window/drive/drive_interface.hpp"

namespace darwinop::window {

class MotionPlanner {
 public:
  static constexpr double kSliderSpeed = 2.0;  // rad/s of slider goals; walk and pages have their own speeds

  /// `pages` must outlive it.
  explicit MotionPlanner(const motion::PageFile& pages) : page_{pages} {}

  /// Joint commands of the next cycle; those of earlier cycles persist until they change. `ms`: time since the last
  /// call.
  [[nodiscard]] const Commands& plan(DriveRequests requests, const Sensors& seen, double ms);
  [[nodiscard]] const DriveStatus& status() const { return status_; }
  /// Neither a walk nor a page is running.
  [[nodiscard]] bool atRest() const { return !walks() && !page_.isPlaying(); }

 private:
  void applyRequests(DriveRequests& requests, const Sensors& seen, double ms);
  void abortMotion(const char* why);
  [[nodiscard]] bool hasPositions(std::size_t limb, const Sensors& seen);
  void switchTorque(const DriveRequests& requests, const Sensors& seen);
  [[nodiscard]] bool beginPage(int page, const Sensors& seen);
  [[nodiscard]] bool beginWalk(const Sensors& seen);
  void applyGoals(const DriveRequests& requests);
  void advanceWalk(const DriveRequests& requests, const Sensors& seen, double ms);
  void advancePage(double ms);
  void setGoal(std::size_t joint, double rad, double speed);
  void resetGains();
  [[nodiscard]] bool walks() const { return !walk_.walk().resting(); }
  [[nodiscard]] bool isLimp(std::size_t joint) const;

  body_player::PagePlayer page_;
  body_player::WalkPlayer walk_{gait::Parameters{}};
  body_player::Following following_;
  double default_gain_ = 4;    // Kp of a joint that no motion moves; until the robot reports its own
  bool walk_blocked_ = false;  // until the walk request is withdrawn
  DriveStatus status_{};
  Commands commands_{};  // of this cycle
};

}  // namespace darwinop::window
