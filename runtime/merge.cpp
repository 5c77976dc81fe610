#include "runtime/merge.hpp"

namespace darwinop::runtime {
namespace {

void mergeJoint(const ServoReading& reading, JointSensors& joint) noexcept {
  if (reading.answered) {
    joint.motion.received();
    joint.position = reading.position;
    joint.velocity = reading.velocity;
    joint.load = reading.load;
    joint.error_bits = reading.error_bits;
  } else {
    joint.motion.missed();
  }
  if (reading.answered && reading.polled) {
    joint.polled.received();
    joint.voltage = reading.voltage;
    joint.temperature = reading.temperature;
    joint.torque_limit = reading.torque_limit;
    joint.goal = reading.goal;
    joint.speed_limit = reading.speed_limit;
    joint.torque_enabled = reading.torque_enabled;
  } else {
    joint.polled.missed();
  }
}

void mergeBoard(const BoardReading& reading, BoardSensors& board) noexcept {
  if (!reading.answered) {
    board.motion.missed();
    return;
  }
  board.motion.received();
  board.gyro = reading.gyro;
  board.accelerometer = reading.accelerometer;
  board.buttons = reading.buttons;
  board.voltage = reading.voltage;
  board.microphone_left = reading.microphone_left;
  board.servo_power = reading.servo_power;
  board.led_panel = reading.led_panel;
  board.led_head = reading.led_head;
  board.led_eye = reading.led_eye;
  board.error_bits = reading.error_bits;
}

/// The board's values stay unknown: its age stays "never".
[[gnu::cold, gnu::noinline]] void mergeWithoutBoard(const BusReadings& readings, Sensors& sensors) noexcept {
  sensors.board.absent = true;
  if (readings.servos_answered)
    sensors.bus.received();
  else
    sensors.bus.missed();
}

}  // namespace

void merge(const BusReadings& readings, Sensors& sensors) noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) mergeJoint(readings.servo[i], sensors.joint[i]);
  if (readings.board.absent) {
    mergeWithoutBoard(readings, sensors);
  } else {
    mergeBoard(readings.board, sensors.board);
    sensors.bus = sensors.board.motion;
  }
  sensors.link = readings.link;
  sensors.wire = readings.wire;
  sensors.silent = readings.silent;
}

void missCycles(std::uint32_t cycles, Sensors& sensors) noexcept {
  for (JointSensors& joint : sensors.joint) {
    joint.motion.missed(cycles);
    joint.polled.missed(cycles);
  }
  sensors.board.motion.missed(cycles);
  sensors.bus.missed(cycles);
}

void noteCommanded(const SafeCommands& sent, Sensors& sensors) noexcept {
  for (std::size_t i = 0; i < kJoints; ++i) {
    JointSensors& joint = sensors.joint[i];
    joint.driven = sent.driven().test(i);
    joint.commanded = joint.driven ? sent.goal(static_cast<Joint>(i)).goal : Rad{};
  }
}

}  // namespace darwinop::runtime
