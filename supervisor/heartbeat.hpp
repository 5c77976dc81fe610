// Does the loop still turn? Judged by its cycle counter in the exchange. Pure: time is an argument.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::supervisor {

class Heartbeat {
 public:
  /// A cycle never waits longer than its own period: reading the bus ends at a deadline inside it, and when the port is
  /// lost the loop turns on without one while another thread looks for it. So half a second is thirty cycles of 16 ms,
  /// far above a legitimate stall, and short enough for a robot that stands: nobody corrects its last goals meanwhile.
  /// Slow loops (periods up to 1 s are allowed) get ten of their periods.
  static constexpr Nanos kShortest{500'000'000};
  /// One look counts for no more than this. After a time in which the supervisor itself did not run (the whole machine
  /// stood still) the loop gets its chance to turn first.
  static constexpr Nanos kLook{50'000'000};

  explicit Heartbeat(Nanos period) : patience_{std::max(kShortest, 10 * period)} {}

  /// For every look, at least every kLook. False: it has not moved for too long.
  [[nodiscard]] bool beats(std::uint32_t cycles, Nanos now) {
    if (!any_ || cycles != cycles_)
      silent_ = Nanos{0};
    else
      silent_ += std::min(now - looked_, kLook);
    any_ = true;
    cycles_ = cycles;
    looked_ = now;
    return silent_ < patience_;
  }
  [[nodiscard]] Nanos patience() const { return patience_; }

 private:
  Nanos patience_;
  bool any_ = false;
  std::uint32_t cycles_ = 0;
  Nanos looked_{0}, silent_{0};
};

}  // namespace darwinop::supervisor
