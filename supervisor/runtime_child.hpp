// The runtime as a child: is it ready, does it beat, what does the robot look like?
#pragma once

#include <optional>

#include "core/sensors.hpp"
#include "runtime/exchange_reader.hpp"
#include "runtime/names.hpp"
#include "supervisor/child.hpp"
#include "supervisor/heartbeat.hpp"

namespace darwinop::supervisor {

class RuntimeChild {
 public:
  enum class State {
    kStarting,  // it lives and has not run a cycle yet: it waits for the port, or looks at the robot
    kUp,        // its loop turns
    kSilent,    // it lives and its loop has not turned for too long
    kEnded,
  };

  RuntimeChild(const Start& start, const runtime::RuntimeFiles& files) : files_{files}, child_{start} {}

  /// At least every Heartbeat::kLook.
  [[nodiscard]] State look(Nanos now);
  /// It was ready at some time, so that robot and controller may rely on it.
  [[nodiscard]] bool wasUp() const { return heart_.has_value(); }
  [[nodiscard]] const Sensors& sensors() const { return seen_; }
  [[nodiscard]] Nanos patience() const { return heart_ ? heart_->patience() : Nanos{0}; }
  [[nodiscard]] Child& process() { return child_; }

 private:
  void attach();

  runtime::RuntimeFiles files_;
  Child child_;
  std::optional<runtime::ExchangeReader> exchange_;  // not mapped: the supervisor outlives the file
  std::optional<Heartbeat> heart_;
  Sensors seen_;
};

}  // namespace darwinop::supervisor
