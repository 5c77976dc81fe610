// A robot that remembers what was asked of it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "remote/server/robot_port.hpp"

namespace darwinop::remote {

struct FakeRobotPort final : RobotPort {
  std::vector<std::string> events;  // "fresh", "again", "hold"
  std::vector<Request> obeyed;
  Sensors seen{};
  std::string refusal, must_end;
  bool driven = false;

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

  void begin(Beginning beginning) override {
    if (!refusal.empty()) throw std::runtime_error(refusal);
    events.emplace_back(beginning == Beginning::kFresh ? "fresh" : "again");
    driven = true;
  }
  void leaveAlone() noexcept override {
    events.emplace_back("left alone");
    driven = false;
  }
  void obey(const Request& request) override { obeyed.push_back(request); }
  Sensors sensors() override { return seen; }
  std::string mustEnd() override { return must_end; }
  void hold() noexcept override {
    events.emplace_back("hold");
    driven = false;
  }
  void farewell() noexcept override {
    events.emplace_back("farewell");
    driven = false;
  }
};

}  // namespace darwinop::remote
