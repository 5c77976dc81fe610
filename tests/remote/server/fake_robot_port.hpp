// RobotPort that records its calls.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "remote/server/robot_port.hpp"

namespace darwinop::remote {

struct FakeRobotPort final : RobotPort {
  std::vector<std::string> events;  // "new", "resumed", "hold"
  std::vector<Request> applied;
  Sensors seen{};
  std::string refusal, must_end, end_request;
  bool driven = false;
  std::function<void()> on_apply{};  // what else a request does, for example take time

  FakeRobotPort() {
    for (std::size_t i = 0; i < kJoints; ++i) {
      seen.joint[i].motion.received();
      seen.joint[i].position = Rad{0.001 * static_cast<double>(i)};
      seen.joint[i].load = 0;
    }
    seen.board.motion.received();
    seen.board.accelerometer.fill(MeterPerSec2{0});
    seen.board.gyro.fill(RadPerSec{0});
  }

  void startSession(SessionStart start) override {
    if (!refusal.empty()) throw std::runtime_error(refusal);
    events.emplace_back(start == SessionStart::kNew ? "new" : "resumed");
    driven = true;
  }
  void cancelSession() noexcept override {
    events.emplace_back("left alone");
    driven = false;
  }
  void apply(const Request& request) override {
    applied.push_back(request);
    if (on_apply) on_apply();
  }
  Sensors sensors() override { return seen; }
  std::string endReason() override { return must_end; }
  std::string endRequest() override { return end_request; }
  void hold() noexcept override {
    events.emplace_back("hold");
    driven = false;
  }
  void endSession() noexcept override {
    events.emplace_back("end");
    driven = false;
  }
};

}  // namespace darwinop::remote
