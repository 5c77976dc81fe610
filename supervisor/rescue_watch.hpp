// The course of a rescue, read off the sensor images of its loop: hold, crouch, torque off. Pure.
#pragma once

#include <cstdint>
#include <optional>

#include "core/sensors.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::supervisor {

class RescueWatch {
 public:
  enum class Step {
    kHold,    // nothing is sent; servos that hold go on holding
    kCrouch,  // safety is told that nobody drives: slow move to the start pose, then torque off
    kAtRest,  // done
    kStiff,   // done, but some servo still holds its joint, or would not say
  };
  // Who stands by sees the red light before anything moves. Also long enough that every servo has told whether it
  // holds its joint: safety looks at one in each cycle.
  static constexpr Nanos kHold{1'000'000'000};

  /// `crouch_at_most`: longer than a crouch from anywhere takes (runtime::Rest reckons it).
  RescueWatch(Nanos period, Nanos crouch_at_most);

  /// For successive images. Time in which the board does not answer does not count.
  [[nodiscard]] Step look(const Sensors& seen) noexcept;
  /// The board has answered in the newest image.
  [[nodiscard]] bool online() const noexcept { return online_; }

 private:
  std::uint64_t hold_, settled_, at_most_;  // cycles
  std::uint64_t last_ = 0;                  // number of the newest image
  std::uint64_t heard_ = 0, crouching_ = 0, limp_ = 0;
  bool online_ = false;
};

/// Some servo that is heard says that it holds its joint.
[[nodiscard]] bool anyStiff(const Sensors& seen) noexcept;

}  // namespace darwinop::supervisor
