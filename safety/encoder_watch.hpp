// Detects a stuck encoder: the motor pushes in both directions, and the position stays the same.
#pragma once

#include <algorithm>

#include "core/sensors.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// A joint that is blocked from one side, is at a stop or carries a load may legitimately not move. But no joint stays
/// on the same tick when pushed in both directions: gears have backlash (an MX-28 about 0.25 deg, 3 ticks).
class EncoderWatch {
 public:
  /// `push`: torque of the servo towards its goal, N m, signed; 0: unknown or too small to count.
  void update(const JointSensors& seen, double push, Nanos dt) noexcept {
    if (!seen.motion.fresh()) return;
    if (seen.position != position_ || !seen.torque_enabled) *this = EncoderWatch{};
    position_ = seen.position;
    if (push >= kPush) up_ += dt;
    if (push <= -kPush) down_ += dt;
  }
  [[nodiscard]] bool stuck() const noexcept { return std::min(up_, down_) >= kLongEnough; }

  static constexpr double kPush = 0.75;                                // N m; gear friction is about 0.2
  static constexpr Nanos kLongEnough{std::chrono::milliseconds{500}};  // each way; a leg moves 0.1 rad in it

 private:
  Rad position_;
  Nanos up_{0}, down_{0};
};

}  // namespace darwinop::safety
