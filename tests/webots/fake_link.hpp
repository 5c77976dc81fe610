// A robot in memory with a clock that the test moves: records what is published, serves the image the test made.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/conversions.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::webots_api {

/// What test and link share; it outlives the link, as the robot does.
struct FakeRobot {
  Nanos period{16'000'000};
  Nanos bus_time{4'000'000};  // a cycle ends this long after its release
  Nanos now{0};
  Sensors image;  // served with cycle number and times filled in
  std::vector<Commands> published;
  std::function<void(std::uint64_t cycle)> on_cycle;  // may change the image
  std::function<std::unique_ptr<FrameSource>(int width, int height)> open_camera;
  bool gone = false;    // the daemon died
  bool ending = false;  // the daemon is requested to end: one wait is in vain
  bool end_of_session = false;
  bool real_time = true;              // the controller's process hosts the loop; false: lockstep
  std::function<void()> during_wait;  // called once, inside waitForCycle: raises a signal, or requests a stop

  FakeRobot() {
    image.safety.state = State::kDriven;
    image.board.motion.received();
    image.board.gyro.fill(RadPerSec{0});
    image.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
    image.board.voltage = Volt{11.8};
    for (std::size_t i = 0; i < kJoints; ++i) {
      JointSensors& joint = image.joint[i];
      joint.motion.received();
      joint.position = joint.commanded = radFromTicks(kJointTable[i].start);
      joint.velocity = RadPerSec{0};
      joint.load = 0;
      joint.driven = true;
    }
  }

  /// Lets the clock run; cycles end meanwhile.
  void pass(Nanos time) { now += time; }
  /// Cycles that have ended by now.
  [[nodiscard]] std::uint64_t finished() const {
    return now < bus_time ? 0 : static_cast<std::uint64_t>((now - bus_time) / period);
  }
  [[nodiscard]] const Commands& last() const { return published.back(); }
};

class FakeLink : public runtime::RobotLink {
 public:
  explicit FakeLink(FakeRobot& robot) : robot_{robot} {}
  ~FakeLink() override { robot_.end_of_session = true; }

  [[nodiscard]] Nanos period() const override { return robot_.period; }
  [[nodiscard]] Nanos now() const override { return robot_.now; }
  [[nodiscard]] bool realTime() const override { return robot_.real_time; }
  void publish(Commands commands) override { robot_.published.push_back(commands); }
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height) override {
    return robot_.open_camera ? robot_.open_camera(width, height) : nullptr;
  }

  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override {
    if (robot_.during_wait) std::exchange(robot_.during_wait, nullptr)();
    if (stop || robot_.gone || std::exchange(robot_.ending, false)) return false;
    while (robot_.finished() < cycle) {
      robot_.now = static_cast<std::int64_t>(robot_.finished() + 1) * robot_.period + robot_.bus_time;
      if (robot_.on_cycle) robot_.on_cycle(robot_.finished());
    }
    return true;
  }

  [[nodiscard]] Sensors sensors() const override {
    Sensors image = robot_.image;
    image.cycle = robot_.finished();
    image.time_ns = static_cast<std::int64_t>(image.cycle) * robot_.period.count();
    image.period_ns = robot_.period.count();
    image.wire.bus_ns = robot_.bus_time.count();
    return image;
  }

  [[nodiscard]] std::string whyEnded() const override { return "the daemon has gone"; }

 private:
  FakeRobot& robot_;
};

}  // namespace darwinop::webots_api
