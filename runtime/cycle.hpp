// One control cycle, every 16 ms, in the loop's thread: check commands, write goals, read sensors.
#pragma once

#include <cstdint>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "hal/byte_line.hpp"
#include "hal/servo_bus.hpp"
#include "safety/guard.hpp"

namespace darwinop::runtime {

/// Timing of a cycle, measured by its caller (Pacer).
struct CycleTime {
  Nanos release{0};            // scheduled start, on the loop's clock
  Nanos wake_latency{0};       // actual start minus release
  Nanos slack{0};              // of the previous cycle: from its end to the next release; negative: overrun
  std::uint32_t overruns = 0;  // cumulative
};

/// Has no thread, no clock and no heap memory of its own. Only the thread that calls run() uses the bus.
class Cycle {
 public:
  Cycle(ServoBus& bus, safety::Guard& guard, Nanos period);

  /// Runs one cycle. `asked`: the newest commands of the controller, unchecked. Blocks only on the bus. Never
  /// allocates, locks, logs or throws.
  void run(const Commands& asked, const CycleTime& time) noexcept;

  /// Sensor image after the last run().
  [[nodiscard]] const Sensors& sensors() const noexcept { return sensors_; }

 private:
  void noteStall(const CycleTime& time) noexcept;
  void account(const CycleTime& time) noexcept;

  ServoBus& bus_;
  safety::Guard& guard_;
  BusReadings readings_{};
  Sensors sensors_{};
  Nanos began_{0};  // start of the last cycle
};

}  // namespace darwinop::runtime
