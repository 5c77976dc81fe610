// The parts that make a loop, put together: what an embedded, a lockstep and a daemon home have in common.
#pragma once

#include <memory>
#include <string>

#include "hal/servo_bus.hpp"
#include "runtime/exchange.hpp"
#include "runtime/loop.hpp"
#include "runtime/periodic_driver.hpp"
#include "runtime/recorder.hpp"
#include "safety/config.hpp"
#include "safety/guard.hpp"

namespace darwinop::runtime {

struct LoopConfig {
  Nanos period{16'000'000};         // 8 ms to 1 s
  safety::Config safety{};          // its period is set to the one above
  std::string robot = "darwin-op";  // a person's name for it, for the recording and for --status
  std::string port;                 // what the bus is, as OpenedBus describes it
  std::string record_path;          // empty: no recording
  std::string record_notes;         // LogHead::notes
  RealTimeConfig real_time{};       // not used in lockstep
};

/// The same. Throws std::runtime_error for a period out of range.
const LoopConfig& checked(const LoopConfig& config);

class LoopHost {
 public:
  /// Throws std::runtime_error for a period out of range or a recording that cannot be written.
  LoopHost(const LoopConfig& config, std::unique_ptr<ServoBus> bus, const Exchange& exchange, LoopStats::Timed timed,
           Recorder::Writer writer);

  [[nodiscard]] Loop& loop() { return loop_; }
  [[nodiscard]] Recorder* recorder() { return recorder_.get(); }

 private:
  std::unique_ptr<ServoBus> bus_;
  safety::Guard guard_;
  std::unique_ptr<Recorder> recorder_;
  Loop loop_;
};

}  // namespace darwinop::runtime
