// Scripted servo bus.
#include "hil-mocks/scripted_bus.hpp"

#include <string>

#include "core/conversions.hpp"

namespace darwinop::hil {

BusReadings readingsAtRest() {
  BusReadings readings;
  for (std::size_t i = 0; i < kJoints; ++i) {
    ServoReading& servo = readings.servo[i];
    servo.answered = true;
    servo.position = radFromTicks(kJointTable[i].start);
    servo.velocity = RadPerSec{0};
    servo.load = 0;
  }
  readings.board.answered = true;
  readings.board.gyro.fill(RadPerSec{0});
  readings.board.accelerometer = {MeterPerSec2{0}, MeterPerSec2{0}, MeterPerSec2{9.80665}};
  readings.board.voltage = Volt{11.8};
  readings.board.microphone_left = 512;
  readings.board.servo_power = true;
  return readings;
}

ScriptedBus::~ScriptedBus() {
  std::size_t left = 0;
  for (const Step& step : steps_) left += step.count;
  if (left > 0)
    failure_(std::to_string(left) + " scripted cycles were not reached, " + std::to_string(cycles_run_) + " were");
}

ScriptedBus& ScriptedBus::cycles(std::size_t count, const BusReadings& readings) {
  if (count > 0) steps_.push_back({count, readings, {}});
  return *this;
}

ScriptedBus& ScriptedBus::expectWrite(Check check) {
  if (!steps_.empty()) steps_.back().check = std::move(check);
  return *this;
}

void ScriptedBus::write(const SafeCommands& commands) noexcept {
  if (written_) failure_("written twice in cycle " + std::to_string(cycles_run_ + 1));
  if (steps_.empty()) failure_("written after the last scripted cycle, number " + std::to_string(cycles_run_));
  written_ = true;
  if (!steps_.empty() && steps_.front().check) steps_.front().check(commands);
}

void ScriptedBus::read(BusReadings& readings) noexcept {
  if (!written_) failure_("read before it was written in cycle " + std::to_string(cycles_run_ + 1));
  readings = BusReadings{};
  written_ = false;
  ++cycles_run_;
  if (steps_.empty()) return;
  readings = steps_.front().readings;
  if (--steps_.front().count == 0) steps_.pop_front();
}

}  // namespace darwinop::hil
