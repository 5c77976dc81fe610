// Bus, safety layer, recorder and loop as one object; used by ThreadedLink, LockstepLink and Daemon.
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
  safety::Config safety{};          // its period is replaced by the one above
  std::string robot = "darwin-op";  // the robot's name, for recordings and --status
  std::string port;                 // description of the bus: connect::OpenedBus
  std::string record_path;          // empty: no recording
  std::string record_notes;         // LogHead::notes
  RealTimeConfig real_time{};       // ignored in lockstep
  bool trunk_is_held = false;       // for messages: FaultAnnouncer
};

/// Returns `config`. Throws std::runtime_error if the period is out of range.
const LoopConfig& checked(const LoopConfig& config);

/// What clients of the loop see of its settings.
LoopInfo describe(const LoopConfig& config);

class LoopHost {
 public:
  /// Throws std::runtime_error if the period is out of range or the recording cannot be written.
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
