// Robot link in simulated time: a cycle runs when the controller waits for it, in the controller's thread.
#pragma once

#include <functional>
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
  /// Opens the camera of the simulated robot.
  using CameraOpener = std::function<std::unique_ptr<FrameSource>(int width, int height)>;

  /// `clock`: the simulation's. Throws std::runtime_error with a remedy.
  LockstepLink(const LoopConfig& config, std::unique_ptr<ServoBus> bus, std::unique_ptr<Clock> clock,
               CameraOpener open_camera = {});
  ~LockstepLink() override;

  [[nodiscard]] Nanos now() const override { return clock_->now(); }
  [[nodiscard]] bool realTime() const override { return false; }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height) override;

 private:
  void run();

  Rest rest_;
  std::unique_ptr<Clock> clock_;
  LoopHost host_;
  LockstepDriver driver_;
  CameraOpener open_camera_;
  FaultAnnouncer announcer_;
};

}  // namespace darwinop::runtime
