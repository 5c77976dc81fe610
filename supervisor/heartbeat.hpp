// Heartbeat of the loop, from its cycle counter in the exchange. Pure: time is an argument.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/byte_line.hpp"

namespace darwinop::supervisor {

class Heartbeat {
 public:
  /// A cycle takes little longer than its period: bus reads end at a deadline, which at 8 ms a missing reply moves
  /// beyond it, and after the loss of the port the loop continues without it. Half a second is thirty cycles of 16 ms:
  /// far above a legitimate stall, and short for a standing robot whose last goals are not corrected meanwhile. Slow
  /// loops (periods up to 1 s are allowed) get ten periods.
  static constexpr Nanos kShortest{500'000'000};
  /// Maximum time credited per check. If the supervisor itself did not run (the whole machine was stopped), the loop
  /// first gets time to run.
  static constexpr Nanos kCheckInterval{50'000'000};

  explicit Heartbeat(Nanos period) : patience_{std::max(kShortest, 10 * period)} {}

  /// Call at every check, at least every kCheckInterval. Returns false if the counter has not changed for too long.
  [[nodiscard]] bool beats(std::uint32_t cycles, Nanos now) {
    if (!any_ || cycles != cycles_)
      silent_ = Nanos{0};
    else
      silent_ += std::min(now - checked_, kCheckInterval);
    any_ = true;
    cycles_ = cycles;
    checked_ = now;
    return silent_ < patience_;
  }
  [[nodiscard]] Nanos patience() const { return patience_; }

 private:
  Nanos patience_;
  bool any_ = false;
  std::uint32_t cycles_ = 0;
  Nanos checked_{0}, silent_{0};
};

}  // namespace darwinop::supervisor
