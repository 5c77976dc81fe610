// Finds an encoder that is stuck: the motor pushes one way and then the other, and the position stays the same.
#pragma once

#include <algorithm>

#include "core/sensors.hpp"
#include "safety/config.hpp"

namespace darwinop::safety {

/// A joint that is blocked from one side, stands at a stop or carries a load may well stay where it is. None stays on
/// the same tick when it is pushed both ways: gears have play (an MX-28 about 0.25 deg, 3 ticks), and a hand gives way.
class EncoderWatch {
 public:
  /// `push`: torque that the servo makes to reach its goal, N m with its sign; 0: unknown, or too little to count.
  void update(const JointSensors& seen, double push, Nanos dt) noexcept {
    if (!seen.motion.fresh()) return;
    if (seen.position != position_ || !seen.torque_enabled) *this = EncoderWatch{};
    position_ = seen.position;
    if (push >= kPush) up_ += dt;
    if (push <= -kPush) down_ += dt;
  }
  [[nodiscard]] bool stuck() const noexcept { return std::min(up_, down_) >= kLongEnough; }

  static constexpr double kPush = 0.75;                                // N m; friction of the gears takes about 0.2
  static constexpr Nanos kLongEnough{std::chrono::milliseconds{500}};  // each way; a leg moves 0.1 rad in that time

 private:
  Rad position_;
  Nanos up_{0}, down_{0};
};

}  // namespace darwinop::safety
