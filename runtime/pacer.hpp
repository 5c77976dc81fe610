// The grid of releases: one cycle per grid point, and what happens when a cycle comes too late.
#pragma once

#include <cstdint>

#include "runtime/clock.hpp"
#include "runtime/cycle.hpp"

namespace darwinop::runtime {

/// Releases are first, first + period, first + 2 periods, and so on, whatever happens: the next one is counted from
/// the last release and never from now. A cycle that is still running at the next release is an overrun; the
/// releases it covered are skipped, never made up for in a burst.
class Pacer {
 public:
  /// The first release is one period from now.
  Pacer(Clock& clock, Nanos period) : clock_{clock}, period_{period}, next_{clock.now() + period} {}

  /// Sleeps until the next release, runs `cycle(const CycleTime&)` once and accounts.
  template <class F>
  void step(F&& cycle) noexcept {
    clock_.sleepUntil(next_);
    time_.release = next_;
    time_.wake_latency = clock_.now() - next_;
    cycle(static_cast<const CycleTime&>(time_));
    finish(clock_.now());
  }

  /// Releases given up so far.
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
