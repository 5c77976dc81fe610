// Embedded loop: runs in a thread of the controller's process.
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
  /// Starts the loop. The exchange is in private memory, or in the file named by DARWINOP_EXCHANGE, where other
  /// processes can observe. Throws std::runtime_error with a remedy.
  ThreadedLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus);
  /// Ends the session, lets safety bring the robot to rest, ends the loop.
  ~ThreadedLink() override;

  [[nodiscard]] Nanos now() const override { return clock_.now(); }
  [[nodiscard]] bool realTime() const override { return true; }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;

  /// Real-time settings that the kernel refused, with a remedy; empty: none.
  [[nodiscard]] const std::string& warning() const { return driver_.warning(); }

 private:
  Rest rest_;
  MonotonicClock clock_;
  LoopHost host_;
  PeriodicDriver driver_;  // after the members it uses: destroyed before them
  FaultWatch watch_;
};

}  // namespace darwinop::runtime
