// The loop's time: CLOCK_MONOTONIC on a robot, a simulated clock in lockstep, a scripted one in tests.
#pragma once

#include "hal/byte_line.hpp"

namespace darwinop::runtime {

class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual Nanos now() const noexcept = 0;
  /// Returns at `time` or later; at once when it has passed. A simulated clock jumps there.
  virtual void sleepUntil(Nanos time) noexcept = 0;
};

/// CLOCK_MONOTONIC: never set back, and the same for all processes of a machine.
class MonotonicClock final : public Clock {
 public:
  [[nodiscard]] Nanos now() const noexcept override;
  void sleepUntil(Nanos time) noexcept override;
};

}  // namespace darwinop::runtime
