// Rate limiter (token bucket): bounds the share of a robot's CPU that clients of a server can use.
#pragma once

#include <algorithm>

#include "hal/byte_line.hpp"

namespace darwinop::net {

class RateLimiter {
 public:
  /// One piece of work every `period` on average, up to `burst` of them after a pause. `period` 0: no limit.
  RateLimiter(Nanos period, int burst) : period_{period}, credit_{period * burst} {}

  [[nodiscard]] bool allows(Nanos now) const { return wait(now) <= Nanos{0}; }
  /// Time until work is allowed; 0 or less if it is allowed now.
  [[nodiscard]] Nanos wait(Nanos now) const {
    return period_ == Nanos{0} ? Nanos{0} : paid_until_ + period_ - now - credit_;
  }
  /// Counts one piece of work, also beyond the limit; later work waits longer then.
  void spend(Nanos now) { paid_until_ = std::max(paid_until_, now) + period_; }

 private:
  Nanos period_, credit_;
  Nanos paid_until_{0};
};

}  // namespace darwinop::net
