// Embedded home: the controller's process hosts the loop, in a thread of its own.
#pragma once

#include <memory>

#include "runtime/clock.hpp"
#include "runtime/exchange_link.hpp"
#include "runtime/fault_watch.hpp"
#include "runtime/loop_host.hpp"
#include "runtime/rest.hpp"

namespace darwinop::runtime {

class ThreadedLink final : public ExchangeLink {
 public:
  /// Starts the loop. The exchange lies in private memory, or in the file that DARWINOP_EXCHANGE names, where
  /// others can observe. Throws std::runtime_error with what to do.
  ThreadedLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus);
  /// Ends the session, lets safety bring the robot to rest, ends the loop.
  ~ThreadedLink() override;

  [[nodiscard]] Nanos now() const override { return clock_.now(); }
  [[nodiscard]] bool realTime() const override { return true; }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;

  /// Refused real-time settings and the remedy; empty: none.
  [[nodiscard]] const std::string& warning() const { return driver_.warning(); }

 private:
  Rest rest_;
  MonotonicClock clock_;
  LoopHost host_;
  PeriodicDriver driver_;  // after what it uses: it ends before them
  FaultWatch watch_;
};

}  // namespace darwinop::runtime
