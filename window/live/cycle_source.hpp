// Source of the robot's cycles: a local runtime's shared memory or a remote monitor.
#pragma once

#include <functional>
#include <string>

#include "gap/live/live_cycle.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::window {

/// Used by one thread.
class CycleSource {
 public:
  using Take = std::function<void(const gap::live::LiveCycle&)>;
  /// Between two calls of poll(): half of the shortest cycle, 8 ms.
  static constexpr Nanos kPoll{4'000'000};

  virtual ~CycleSource() = default;
  /// Passes on what is new; never waits.
  virtual void poll(Nanos now, const Take& take) = 0;
  /// Why there is no robot; empty: there is one.
  [[nodiscard]] virtual const std::string& reason() const = 0;
};

}  // namespace darwinop::window
