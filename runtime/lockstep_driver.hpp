// Runs the loop in the caller's thread on simulated time: no thread, no waiting, the same run every time.
#pragma once

#include <cstdint>

#include "runtime/clock.hpp"
#include "runtime/loop.hpp"
#include "runtime/pacer.hpp"

namespace darwinop::runtime {

class LockstepDriver {
 public:
  /// `clock` jumps to each release when it is slept on.
  LockstepDriver(Loop& loop, Clock& clock, Nanos period) : loop_{loop}, pacer_{clock, period} {}

  /// Runs that many cycles now.
  void run(std::uint64_t cycles) noexcept {
    for (std::uint64_t i = 0; i < cycles; ++i) loop_.step(pacer_);
  }

 private:
  Loop& loop_;
  Pacer pacer_;
};

}  // namespace darwinop::runtime
