// Computes each cycle's commands from goals, walk and motion pages. Pure: no clock, no thread.
#pragma once

#include <array>
#include <bitset>

#include "core/goals/lead_in.hpp"
#include "core/sensors.hpp"
#include "managers/gait/walk.hpp"
#include "managers/motion/page_file.hpp"
#include "managers/motion/player.hpp"
#include "remote/protocol/request.hpp"
#include "window/drive_interface.hpp"

namespace darwinop::window {

class MotionPlanner {
 public:
  static constexpr double kSliderSpeed = 2.0;  // rad/s of slider goals; walk and pages have their own speeds

  /// `pages` must outlive it.
  explicit MotionPlanner(const motion::PageFile& pages) : player_{pages}, pages_{&pages} {}

  /// Commands of the next cycle. `ms`: time since the last call.
  [[nodiscard]] remote::Request plan(DriveRequests requests, const Sensors& seen, double ms);
  [[nodiscard]] const DriveStatus& status() const { return status_; }
  /// Neither a walk nor a page is running.
  [[nodiscard]] bool atRest() const { return walk_.resting() && !player_.isPlaying(); }

 private:
  void applyRequests(DriveRequests& requests, const Sensors& seen, double ms);
  void abortMotion(const char* why);
  [[nodiscard]] bool hasPositions(std::size_t limb, const Sensors& seen);
  void switchTorque(const DriveRequests& requests, const Sensors& seen);
  void beginPage(int page, const Sensors& seen);
  void beginWalk(const Sensors& seen);
  void applyGoals(const DriveRequests& requests);
  void advanceWalk(const DriveRequests& requests, const Sensors& seen);
  void advancePage();
  void setGoal(std::size_t joint, double rad, double speed);
  void setGain(std::size_t joint, double kp);
  void resetGains();
  [[nodiscard]] bool isLimp(std::size_t joint) const;

  motion::Player player_;
  const motion::PageFile* pages_;
  goals::LeadIn lead_in_;  // moves to the page's first pose
  gait::Walk walk_{gait::Parameters{}};
  double pending_ms_ = 0;
  double not_following_ms_ = 0;   // time that the robot has not followed
  bool walk_blocked_ = false;     // until the walk request is withdrawn
  std::uint64_t gyro_cycle_ = 0;  // cycle of the newest gyroscope reading used
  DriveStatus status_{};
  std::array<remote::MotorSetting, kJoints> settings_{};  // of this cycle
};

}  // namespace darwinop::window
