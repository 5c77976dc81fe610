// A lockstep link to the fake robot, with what a test needs to look behind it.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>

#include "fake_bus.hpp"
#include "runtime/lockstep_link.hpp"
#include "scripted_clock.hpp"

namespace darwinop::runtime {

struct SimulatedRobot {
  std::shared_ptr<FakeRobot> robot = std::make_shared<FakeRobot>();
  std::unique_ptr<LockstepLink> link;
  std::atomic<bool> stop{false};

  explicit SimulatedRobot(const LoopConfig& config = {})
      : link{std::make_unique<LockstepLink>(config, std::make_unique<FakeBus>(robot),
                                            std::make_unique<ScriptedClock>())} {}

  /// Steps as a controller does: publish, wait for the next cycle.
  void step(const Commands& commands = {}, int times = 1) {
    for (int i = 0; i < times; ++i) {
      link->publish(commands);
      (void)link->waitForCycle(link->sensors().cycle + 1, stop);
    }
  }
  [[nodiscard]] bool limp() const {
    return std::none_of(robot->torque.begin(), robot->torque.end(), [](bool on) { return on; });
  }
};

}  // namespace darwinop::runtime
