// Periodic releases on a fixed grid, with overrun handling.
#pragma once

#include <cstdint>

#include "runtime/clock.hpp"
#include "runtime/cycle.hpp"

namespace darwinop::runtime {

/// Releases are at first + n * period, computed from the previous release and never from the present time, so they do
/// not drift. A cycle that still runs at the next release is an overrun; releases that pass meanwhile are skipped,
/// without a burst of cycles to catch up.
class Pacer {
 public:
  /// The first release is one period from now.
  Pacer(Clock& clock, Nanos period) : clock_{clock}, period_{period}, next_{clock.now() + period} {}

  /// Sleeps until the next release, runs `cycle(const CycleTime&)` once and updates the timing.
  template <class F>
  void step(F&& cycle) noexcept {
    clock_.sleepUntil(next_);
    time_.release = next_;
    time_.wake_latency = clock_.now() - next_;
    cycle(static_cast<const CycleTime&>(time_));
    finish(clock_.now());
  }

  /// Releases skipped so far.
  [[nodiscard]] std::uint32_t skipped() const noexcept { return skipped_; }
  [[nodiscard]] Nanos period() const noexcept { return period_; }

 private:
  void finish(Nanos end) noexcept {
    next_ += period_;
    time_.slack = next_ - end;
    if (end <= next_) return;
    ++time_.overruns;
    const auto missed = (end - next_ + period_ - Nanos{1}) / period_;  // rounded up: the next release lies ahead
    skipped_ += static_cast<std::uint32_t>(missed);
    next_ += missed * period_;
  }

  Clock& clock_;
  Nanos period_;
  Nanos next_;
  CycleTime time_{};
  std::uint32_t skipped_ = 0;
};

}  // namespace darwinop::runtime
