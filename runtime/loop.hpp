// One step of the loop, in real and in simulated time: read commands, run a cycle, publish sensors and statistics, wake
// waiting clients.
#pragma once

#include <cstdint>

#include "hal/servo_bus.hpp"
#include "runtime/cycle.hpp"
#include "runtime/exchange.hpp"
#include "runtime/pacer.hpp"
#include "runtime/recorder.hpp"
#include "safety/guard.hpp"

namespace darwinop::runtime {

/// step() runs in the loop's thread and never allocates, locks, logs or throws.
class Loop {
 public:
  /// `exchange` must be hosted by this process; `recorder` may be null. All must outlive the loop.
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
  Commands newest_{};       // the previous image if no newer one is available
  Commands no_commands_{};  // replaces images of a refused session
  // Kept here and never read back from the exchange, which other processes can write.
  std::uint32_t resets_seen_ = 0, releases_seen_ = 0;  // last request numbers
  std::uint32_t fault_resets_ = 0;
  std::uint32_t session_;                // highest number of a session or a release so far
  std::uint32_t released_;               // number of the last release; 0: none. Initial value: ExchangeBlock::released
  std::uint32_t driven_at_release_ = 0;  // session that drove at the last release
};

}  // namespace darwinop::runtime
