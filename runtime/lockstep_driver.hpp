// Runs the loop in the caller's thread in simulated time: no thread, no waiting, reproducible.
#pragma once

#include <cstdint>

#include "runtime/clock.hpp"
#include "runtime/loop.hpp"
#include "runtime/pacer.hpp"

namespace darwinop::runtime {

class LockstepDriver {
 public:
  /// `clock`: simulated; sleepUntil() advances it.
  LockstepDriver(Loop& loop, Clock& clock, Nanos period) : loop_{loop}, pacer_{clock, period} {}

  /// Runs `cycles` cycles.
  void run(std::uint64_t cycles) noexcept {
    for (std::uint64_t i = 0; i < cycles; ++i) loop_.step(pacer_);
  }

 private:
  Loop& loop_;
  Pacer pacer_;
};

}  // namespace darwinop::runtime
