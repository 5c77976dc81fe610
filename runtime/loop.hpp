// One turn of the loop, whoever drives it: newest commands in, a cycle, sensors out, figures, wake-up.
#pragma once

#include <cstdint>

#include "hal/servo_bus.hpp"
#include "runtime/cycle.hpp"
#include "runtime/exchange.hpp"
#include "runtime/pacer.hpp"
#include "runtime/recorder.hpp"
#include "safety/guard.hpp"

namespace darwinop::runtime {

/// Everything here runs in the loop's thread and neither allocates, locks, logs nor throws.
class Loop {
 public:
  /// `recorder` may be null. All must outlive the loop.
  Loop(ServoBus& bus, safety::Guard& guard, ExchangeBlock& block, Recorder* recorder, Nanos period,
       LoopStats::Timed timed);

  /// Runs one cycle at the next release.
  void step(Pacer& pacer) noexcept {
    pacer.step([&](const CycleTime& time) { turn(time, pacer.skipped()); });
  }

 private:
  void turn(const CycleTime& time, std::uint32_t skipped) noexcept;
  [[nodiscard]] Commands withOperator(Commands asked) noexcept;

  Cycle cycle_;
  ExchangeBlock& block_;
  Recorder* recorder_;
  LoopStats::Timed timed_;
  Commands newest_{};  // kept when nothing new can be read
  std::uint64_t release_ticks_ = 0;
};

}  // namespace darwinop::runtime
