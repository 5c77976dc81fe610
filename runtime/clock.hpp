// Clock of the loop: CLOCK_MONOTONIC on a robot, simulated in lockstep, scripted in tests.
#pragma once

#include "hal/byte_line.hpp"

namespace darwinop::runtime {

class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual Nanos now() const noexcept = 0;
  /// Returns at `time` or later; at once if it has passed. A simulated clock advances to `time`.
  virtual void sleepUntil(Nanos time) noexcept = 0;
};

/// CLOCK_MONOTONIC: never set back; the same in all processes of a machine.
class MonotonicClock final : public Clock {
 public:
  [[nodiscard]] Nanos now() const noexcept override;
  void sleepUntil(Nanos time) noexcept override;
};

}  // namespace darwinop::runtime
