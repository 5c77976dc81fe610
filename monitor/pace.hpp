// When the next message of a rate is due.
#pragma once

#include <algorithm>
#include <chrono>

#include "hal/byte_line.hpp"

namespace darwinop::monitor {

/// From one message to the next. `rate` in Hz, more than 0; the smallest number there is would fit into no Nanos.
inline Nanos periodOf(double rate) {
  constexpr double kLongestPeriod = 1e6;  // s: eleven days
  return std::chrono::duration_cast<Nanos>(std::chrono::duration<double>{std::min(1 / rate, kLongestPeriod)});
}

class Pace {
 public:
  /// True: one is due now, and is counted as sent. Late ones are not made up for. `rate` in Hz; 0: never.
  bool due(Nanos now, double rate) {
    if (rate <= 0 || now < next_) return false;
    const Nanos step = periodOf(rate);
    next_ = next_ + step > now ? next_ + step : now + step;
    return true;
  }
  /// The next one is due at once.
  void restart() { next_ = Nanos{0}; }

 private:
  Nanos next_{0};
};

}  // namespace darwinop::monitor
