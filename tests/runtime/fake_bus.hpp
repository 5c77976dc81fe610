// A bus with a robot that reaches its goals one cycle later; no line, no bytes, no time.
#pragma once

#include <memory>

#include "core/conversions.hpp"
#include "hal/servo_bus.hpp"

namespace darwinop::runtime {

/// What the fake robot is like, shared with the test that owns it.
struct FakeRobot {
  std::array<Rad, kJoints> position;
  std::array<bool, kJoints> torque{};
  std::array<bool, kJoints> dead{};
  bool power = true;  // of the servos
  bool unplugged = false;
  double volt = 11.8;
  std::uint32_t writes = 0, reads = 0;
  std::int64_t bus_ns = 5'400'000, wire_ns = 5'340'000;

  FakeRobot() {
    for (std::size_t i = 0; i < kJoints; ++i) position[i] = radFromTicks(kJointTable[i].start);
  }
};

class FakeBus final : public ServoBus {
 public:
  explicit FakeBus(std::shared_ptr<FakeRobot> robot = std::make_shared<FakeRobot>()) : robot_{std::move(robot)} {}

  void write(const SafeCommands& commands) noexcept override {
    poll_ = commands.poll();
    if (commands.write() == SafeCommands::Write::kNothing) return;
    ++robot_->writes;
    for (std::size_t i = 0; i < kJoints; ++i) {
      if (commands.torqueOff()[i]) robot_->torque[i] = false;
      if (commands.torqueOn()[i]) robot_->torque[i] = true;
      if (commands.write() != SafeCommands::Write::kGoals || !commands.driven()[i]) continue;
      robot_->position[i] = commands.goal(static_cast<Joint>(i)).goal;
      robot_->torque[i] = true;
    }
  }

  void read(BusReadings& readings) noexcept override {
    readings = BusReadings{};
    if (robot_->unplugged) return;
    readings.board.answered = true;
    readings.board.servo_power = robot_->power;
    readings.board.voltage = Volt{robot_->volt};
    readings.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.8}};
    for (std::size_t i = 0; i < kJoints; ++i) answer(i, readings.servo[i]);
    readings.link.exchanges = ++robot_->reads;
    readings.wire = {188, 316, robot_->wire_ns, robot_->bus_ns};
  }

 private:
  void answer(std::size_t i, ServoReading& servo) const noexcept {
    servo.answered = robot_->power && !robot_->dead[i];
    if (!servo.answered) return;
    servo.position = robot_->position[i];
    servo.velocity = RadPerSec{0};
    servo.load = 0;
    servo.polled = poll_[i] || robot_->reads % kJoints == i;
    servo.goal = robot_->position[i];
    servo.speed_limit = RadPerSec{1};
    servo.torque_enabled = robot_->torque[i];
    servo.torque_limit = NewtonMeter{2.5};
    servo.voltage = Volt{robot_->volt};
    servo.temperature = Celsius{35};
  }

  std::shared_ptr<FakeRobot> robot_;
  SafeCommands::Mask poll_;
};

}  // namespace darwinop::runtime
