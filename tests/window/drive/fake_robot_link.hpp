// Robot link of window tests: a cycle runs whenever it is waited for, and the test writes the image.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>

#include "runtime/robot_link.hpp"

namespace darwinop::window {

/// The robot, shared by the link and the test.
struct FakeRobot {
  std::mutex mutex;  // guards the members below
  Sensors image{};
  Commands published{};
  bool torque_works = true, loop_runs = true, leased = false, left_holding = false;
};

class FakeRobotLink final : public runtime::RobotLink {
 public:
  explicit FakeRobotLink(FakeRobot& robot) : robot_{robot} { set(&FakeRobot::leased, true); }
  ~FakeRobotLink() override { set(&FakeRobot::leased, false); }

  [[nodiscard]] Nanos period() const override { return Nanos{16'000'000}; }
  [[nodiscard]] Nanos now() const override { return Nanos{0}; }
  [[nodiscard]] bool realTime() const override { return true; }
  void publish(Commands commands) override {
    const std::scoped_lock lock{robot_.mutex};
    robot_.published = commands;
    if (robot_.torque_works) robot_.image.safety.state = State::kDriven;
  }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>&) override {
    std::this_thread::sleep_for(std::chrono::microseconds{200});
    const std::scoped_lock lock{robot_.mutex};
    robot_.image.period_ns = 16'000'000;
    robot_.image.cycle = std::max(robot_.image.cycle, cycle);
    return robot_.loop_runs;
  }
  void leaveHolding() override { set(&FakeRobot::left_holding, true); }
  [[nodiscard]] Sensors sensors() const override {
    const std::scoped_lock lock{robot_.mutex};
    return robot_.image;
  }
  [[nodiscard]] std::string whyEnded() const override { return "loop stopped"; }

 private:
  void set(bool FakeRobot::*member, bool value) {
    const std::scoped_lock lock{robot_.mutex};
    robot_.*member = value;
  }
  FakeRobot& robot_;
};

}  // namespace darwinop::window
