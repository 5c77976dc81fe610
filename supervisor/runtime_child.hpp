// The runtime as a child process: readiness, heartbeat, robot state.
#pragma once

#include <optional>

#include "core/sensors.hpp"
#include "hal/process/child_process.hpp"
#include "runtime/exchange_reader.hpp"
#include "runtime/names.hpp"
#include "safety/config.hpp"
#include "supervisor/heartbeat.hpp"

namespace darwinop::supervisor {

class RuntimeChild {
 public:
  enum class State {
    kStarting,  // alive without a cycle yet: waits for the port, or measures the robot
    kUp,        // its loop runs
    kSilent,    // alive, but without a cycle for too long
    kEnded,
  };

  RuntimeChild(const process::Start& start, const runtime::RuntimeFiles& files) : files_{files}, child_{start} {}

  /// Call at least every Heartbeat::kCheckInterval.
  [[nodiscard]] State update(Nanos now);
  /// It has been ready at some time.
  [[nodiscard]] bool wasUp() const { return heart_.has_value(); }
  [[nodiscard]] const Sensors& sensors() const { return seen_; }
  /// Of its loop; once that runs.
  [[nodiscard]] safety::Config safety() const;
  [[nodiscard]] Nanos patience() const { return heart_ ? heart_->patience() : Nanos{0}; }
  [[nodiscard]] process::ChildProcess& process() { return child_; }

 private:
  void attach();

  runtime::RuntimeFiles files_;
  process::ChildProcess child_;
  std::optional<runtime::ExchangeReader> exchange_;  // not mapped: the supervisor must survive truncation of the file
  std::optional<Heartbeat> heart_;
  Sensors seen_;
};

}  // namespace darwinop::supervisor
