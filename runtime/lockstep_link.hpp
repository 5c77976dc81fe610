// A robot in simulated time: a cycle runs when the controller waits for it, in the controller's thread.
#pragma once

#include <memory>

#include "runtime/clock.hpp"
#include "runtime/exchange_link.hpp"
#include "runtime/fault_announcer.hpp"
#include "runtime/lockstep_driver.hpp"
#include "runtime/loop_host.hpp"
#include "runtime/rest.hpp"

namespace darwinop::runtime {

class LockstepLink final : public ExchangeLink {
 public:
  /// `clock` is the simulation's. Throws std::runtime_error with what to do.
  LockstepLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus, std::unique_ptr<Clock> clock);
  ~LockstepLink() override;

  [[nodiscard]] Nanos now() const override { return clock_->now(); }
  [[nodiscard]] bool realTime() const override { return false; }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;

 private:
  void run();

  Rest rest_;
  std::unique_ptr<Clock> clock_;
  LoopHost host_;
  LockstepDriver driver_;
  FaultAnnouncer announcer_;
};

}  // namespace darwinop::runtime
