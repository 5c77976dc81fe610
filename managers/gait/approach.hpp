// From any pose to the one that walking starts in: all joints together, gently, 8 ms a call.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "managers/gait/goals.hpp"
#include "managers/gait/timing.hpp"

namespace darwinop::gait {

/// Angles in rad, by id minus one.
using Pose = std::array<double, kWalkingJoints>;

inline Pose poseOf(const Goals& goals) {
  Pose pose{};
  for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = goals.rad(i);
  return pose;
}

class Approach {
 public:
  /// rad/s. The joint with the longest way takes this speed on average, and half as much again in the middle. A robot
  /// that gets up from its start pose, sitting, then takes 2.7 s.
  static constexpr double kSpeed = 0.5;
  /// rad. Nearer than this is there: the sway of a stance, not worth a wait.
  static constexpr double kThere = 0.05;
  static constexpr double kLongestMs = 6000;

  Approach() = default;
  /// A joint whose `from` is not known starts at its goal.
  Approach(const Pose& from, const Pose& to) : from_{from}, to_{to} {
    double way = 0;
    for (std::size_t i = 0; i < kWalkingJoints; ++i) {
      if (!std::isfinite(from_[i])) from_[i] = to_[i];
      way = std::max(way, std::abs(to_[i] - from_[i]));
    }
    if (way > kThere) duration_ms_ = std::min(way / kSpeed * 1000, kLongestMs);
  }

  [[nodiscard]] double durationMs() const { return duration_ms_; }
  [[nodiscard]] bool done() const { return time_ms_ >= duration_ms_; }

  /// At rest at both ends.
  Pose next() {
    time_ms_ = std::min(time_ms_ + kTickMs, duration_ms_);
    if (done()) return to_;
    const double t = time_ms_ / duration_ms_, share = t * t * (3 - 2 * t);
    Pose pose{};
    for (std::size_t i = 0; i < kWalkingJoints; ++i) pose[i] = from_[i] + share * (to_[i] - from_[i]);
    return pose;
  }

 private:
  Pose from_{}, to_{};
  double duration_ms_ = 0, time_ms_ = 0;
};

}  // namespace darwinop::gait
