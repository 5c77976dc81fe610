// The cycle: what happens every 16 ms, in this order and in this thread.
#pragma once

#include <cstdint>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "hal/byte_line.hpp"
#include "hal/servo_bus.hpp"
#include "safety/guard.hpp"

namespace darwinop::runtime {

/// When a cycle should have begun, and how the one before it went. Filled in by the driver, which has the clock.
struct CycleTime {
  Nanos release{0};            // on the loop's clock
  Nanos wake_latency{0};       // began this late
  Nanos slack{0};              // of the previous cycle: its end to the release after it; negative: overrun
  std::uint32_t overruns = 0;  // so far
};

/// Owns no thread, no clock, no memory beyond its members. The caller is the only thread that touches the bus.
class Cycle {
 public:
  Cycle(ServoBus& bus, safety::Guard& guard, Nanos period);

  /// Runs one cycle. Blocks for the bus only. Never allocates, locks, logs or throws.
  void run(const Commands& asked, const CycleTime& time) noexcept;

  /// What is known after the last run.
  [[nodiscard]] const Sensors& sensors() const noexcept { return sensors_; }

 private:
  void account(const CycleTime& time) noexcept;

  ServoBus& bus_;
  safety::Guard& guard_;
  BusReadings readings_{};
  Sensors sensors_{};
};

}  // namespace darwinop::runtime
