// From where the joints are to where a recorded movement begins: all together, at rest at both ends, never fast.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "core/joints.hpp"

namespace darwinop::facade {

/// Angles in rad. Allocates nothing.
class LeadIn {
 public:
  using Pose = std::array<double, kJoints>;

  /// rad/s, 11.4 rpm: what the goal of the joint with the longest way takes in the middle. The runtime brings a robot
  /// to its start pose as fast as that, unless config.ini says otherwise (gentle_speed, safety/config.hpp).
  static constexpr double kSpeed = 1.194;

  LeadIn() = default;  // done
  LeadIn(const Pose& from, const Pose& to) : from_{from}, to_{to} {
    double way = 0;
    for (std::size_t i = 0; i < kJoints; ++i) way = std::max(way, std::abs(to_[i] - from_[i]));
    duration_ms_ = durationMs(way);
  }

  /// For the longest way of a joint.
  static double durationMs(double way) { return kSteepest * way / kSpeed * 1000; }

  [[nodiscard]] bool done() const { return time_ms_ >= duration_ms_; }
  void advance(double ms) { time_ms_ = std::min(time_ms_ + ms, duration_ms_); }
  [[nodiscard]] double at(std::size_t joint) const {
    if (done()) return to_[joint];
    const double t = time_ms_ / duration_ms_;
    return from_[joint] + t * t * (3 - 2 * t) * (to_[joint] - from_[joint]);
  }

 private:
  static constexpr double kSteepest = 1.5;  // of t * t * (3 - 2 * t), in the middle, as a multiple of its mean

  Pose from_{}, to_{};
  double duration_ms_ = 0, time_ms_ = 0;
};

}  // namespace darwinop::facade
