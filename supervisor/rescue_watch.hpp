// Progress of a rescue, from the sensor images of its loop: hold, crouch, torque off. Pure.
#pragma once

#include <cstdint>
#include <optional>

#include "core/sensors.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::supervisor {

class RescueWatch {
 public:
  enum class Step {
    kHold,    // no commands; servos hold their last goal
    kCrouch,  // the safety layer has no driver: slow move to the start pose, then torque off
    kAtRest,  // done
    kStiff,   // done, but some servo holds its joint or did not answer
  };
  // Bystanders see the red light before anything moves. Also long enough to read the torque state of every servo: one
  // per cycle.
  static constexpr Nanos kHold{1'000'000'000};

  /// `crouch_at_most`: upper bound of a crouch from any pose (computed by runtime::Rest).
  RescueWatch(Nanos period, Nanos crouch_at_most);

  /// Call with successive images. Time without a response of the board does not count.
  [[nodiscard]] Step update(const Sensors& seen) noexcept;
  /// The board answered in the newest image.
  [[nodiscard]] bool online() const noexcept { return online_; }

 private:
  std::uint64_t hold_, settled_, at_most_;  // cycles
  std::uint64_t last_ = 0;                  // number of the newest image
  std::uint64_t answered_cycles_ = 0, crouching_ = 0, limp_ = 0;
  bool online_ = false;
};

/// Some responding servo holds its joint.
[[nodiscard]] bool anyStiff(const Sensors& seen) noexcept;

}  // namespace darwinop::supervisor
