// One turn of the loop, for every kind of driver: newest commands in, a cycle, sensors out, figures, wake-up.
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
  /// `exchange` is this process' own; `recorder` may be null. All must outlive the loop.
  Loop(ServoBus& bus, safety::Guard& guard, const Exchange& exchange, Recorder* recorder, Nanos period,
       LoopStats::Timed timed);

  /// Runs one cycle at the next release.
  void step(Pacer& pacer) noexcept {
    pacer.step([&](const CycleTime& time) { turn(time, pacer.skipped()); });
  }

 private:
  void turn(const CycleTime& time, std::uint32_t skipped) noexcept;
  [[nodiscard]] const Commands& withOperator() noexcept;
  void takeRequests() noexcept;
  [[nodiscard]] bool isRefused(std::uint32_t session) const noexcept;
  void publish(const Sensors& sensors) noexcept;

  Cycle cycle_;
  const Exchange& exchange_;
  ExchangeBlock& block_;
  CommandBlock& requests_;
  Recorder* recorder_;
  LoopStats::Timed timed_;
  Commands newest_{};  // kept when nothing new can be read
  Commands nobody_{};  // in place of images of a session that is refused
  // The loop's own memory: nothing of this is read back from the exchange.
  std::uint32_t resets_seen_ = 0, releases_seen_ = 0;  // numbers of the requests
  std::uint32_t fault_resets_ = 0;
  std::uint32_t session_;   // highest so far, of a driver or a release
  std::uint32_t released_;  // that the last release got; 0: there was none. Set by the maker of the exchange
  std::uint32_t driven_at_release_ = 0;  // session that was in force then
};

}  // namespace darwinop::runtime
