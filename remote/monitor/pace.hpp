// When the next message of a rate is due.
#pragma once

#include <chrono>

#include "hal/byte_line.hpp"

namespace darwinop::monitor {

class Pace {
 public:
  /// True: one is due now, and is counted as sent. Late ones are not made up for. `rate` in Hz; 0: never.
  bool due(Nanos now, double rate) {
    if (rate <= 0 || now < next_) return false;
    const Nanos step = std::chrono::duration_cast<Nanos>(std::chrono::duration<double>{1 / rate});
    next_ = next_ + step > now ? next_ + step : now + step;
    return true;
  }
  /// The next one is due at once.
  void restart() { next_ = Nanos{0}; }

 private:
  Nanos next_{0};
};

}  // namespace darwinop::monitor
