// Goals, steps and pages as what is said to the robot each cycle. Plain arithmetic: no clock, no thread.
#pragma once

#include <array>
#include <bitset>

#include "core/lead_in.hpp"
#include "core/sensors.hpp"
#include "managers/gait/walk.hpp"
#include "managers/motion/page_file.hpp"
#include "managers/motion/player.hpp"
#include "remote/protocol/request.hpp"
#include "window/helm.hpp"

namespace darwinop::window {

class Moves {
 public:
  static constexpr double kFastest = 2.0;  // rad/s, of a joint that follows a slider; steps and pages have their own

  /// `pages` outlive it.
  explicit Moves(const motion::PageFile& pages) : player_{pages}, pages_{&pages} {}

  /// `ms`: since the last turn.
  [[nodiscard]] remote::Request turn(Orders orders, const Sensors& seen, double ms);
  [[nodiscard]] const Doings& doings() const { return doings_; }
  /// Nothing is under way but single goals.
  [[nodiscard]] bool atRest() const { return walk_.resting() && !player_.isPlaying(); }

 private:
  void heed(Orders& orders, const Sensors& seen, double ms);
  void breakOff(const char* why);
  [[nodiscard]] bool knows(std::size_t limb, const Sensors& seen);
  void switchTorque(const Orders& orders, const Sensors& seen);
  void beginPage(int page, const Sensors& seen);
  void beginWalk(const Sensors& seen);
  void follow(const Orders& orders);
  void advanceWalk(const Orders& orders, const Sensors& seen);
  void advancePage();
  void say(std::size_t joint, double rad, double speed);
  void gain(std::size_t joint, double kp);
  void usualGains();
  [[nodiscard]] bool isLimp(std::size_t joint) const;

  motion::Player player_;
  const motion::PageFile* pages_;
  LeadIn lead_in_;  // before the page's first tick; done when the robot is near enough
  gait::Walk walk_{gait::Parameters{}};
  double carried_ms_ = 0;
  double lost_ms_ = 0;           // for which the robot has not followed
  bool walk_is_barred_ = false;  // until who wants to walk has let go
  std::uint64_t reading_ = 0;    // cycle of the gyroscope's newest one that was looked at
  Doings doings_{};
  std::array<remote::MotorSetting, kJoints> setting_{};  // of this turn
};

}  // namespace darwinop::window
