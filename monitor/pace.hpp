// Decides when the next message at a given rate is due.
#pragma once

#include <algorithm>
#include <chrono>

#include "hal/byte_line.hpp"

namespace darwinop::monitor {

/// Period of a rate. `rate` in Hz, more than 0. Limited, because the period of the smallest double overflows Nanos.
inline Nanos periodOf(double rate) {
  constexpr double kLongestPeriod = 1e6;  // s
  return std::chrono::duration_cast<Nanos>(std::chrono::duration<double>{std::min(1 / rate, kLongestPeriod)});
}

class Pace {
 public:
  /// True: a message is due now and counts as sent. Missed messages are not made up for. `rate` in Hz; 0: never.
  bool due(Nanos now, double rate) {
    if (rate <= 0 || now < next_) return false;
    const Nanos step = periodOf(rate);
    next_ = next_ + step > now ? next_ + step : now + step;
    return true;
  }
  /// The next message is due at once.
  void restart() { next_ = Nanos{0}; }

 private:
  Nanos next_{0};
};

}  // namespace darwinop::monitor
