// A robot without bus and physics for tests of the guard: servos follow their goals at their speed, torque switches
// work, each servo is polled in turn. Faults are set by assigning its fields.
#pragma once

#include <array>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/conversions.hpp"
#include "core/packet.hpp"
#include "core/safe_commands.hpp"
#include "core/sensors.hpp"

namespace darwinop {

struct FakeServo {
  double position = 0;  // rad, where it really is
  double goal = 0;
  double speed = 12;  // rad/s
  double torque_limit = 2.5;
  bool torque = false;
  bool restarted = false;  // since its speed was written
  bool answers = true;
  bool receives = true;
  bool polled = true;              // false: its torque registers are never read
  bool follows = true;             // false: blocked
  std::optional<double> stuck_at;  // what its encoder says, rad
  bool shuts_off = false;          // by overload, as soon as it is written to
  bool remembers = false;          // says overload as long as its torque is off
  std::uint8_t error_bits = 0;
  double celsius = 35;
  double corruption = 0;  // rad, added to the next reading only
};

struct FakeRobot {
  std::array<FakeServo, kJoints> servo{};
  bool board = true;  // false: servos alone, and `board_answers` is about the line
  bool board_answers = true;
  bool board_reply_lost = false;  // the servos' replies arrive, and it carries out what it receives
  bool servo_power = true;
  double volt = 12;
  std::array<double, 3> acceleration{0, 0, 9.8};
  std::uint8_t buttons = 0;
  std::bitset<kJoints> given_up;
  std::int64_t period_ns = 16'000'000;

  Sensors seen{};  // default-built until the first cycle

  FakeRobot() {
    // Off the start pose, and each joint differently, so that crossed wires show.
    for (std::size_t i = 0; i < kJoints; ++i)
      servo[i].position = servo[i].goal =
          radFromTicks(kJointTable[i].start + (i % 2 == 0 ? -1 : 1) * (40 + 5 * static_cast<int>(i))).value;
  }

  FakeServo& operator[](Joint joint) { return servo[index(joint)]; }

  /// One cycle: the robot gets `safe` and is read.
  void cycle(const SafeCommands& safe) {
    if (board_answers) obey(safe);
    const double dt = static_cast<double>(period_ns) * 1e-9;
    for (FakeServo& s : servo) {
      if (!servo_power) s.torque = false;
      if (!s.torque || !s.follows || s.torque_limit <= 0) continue;
      const double way = s.goal - s.position;
      s.position += std::copysign(std::min(std::abs(way), s.speed * dt), way);
    }
    unseen_ |= safe.poll();
    read();
  }

 private:
  std::bitset<kJoints> unseen_;  // since their last answer, or asked to be polled

  void obey(const SafeCommands& safe) {
    if (safe.powerOn()) servo_power = servo_power || power_obeys;
    if (!servo_power) return;
    for (std::size_t i = 0; i < kJoints; ++i) {
      FakeServo& s = servo[i];
      if (!s.receives || safe.skipped()[i]) continue;
      if (safe.write() == SafeCommands::Write::kTorque) {
        if (safe.torqueOn()[i]) s.torque = true;
        if (safe.torqueOff()[i]) s.torque = false;
      }
      if (safe.write() == SafeCommands::Write::kGoals && safe.driven()[i]) {
        const auto& goal = safe.goal(static_cast<Joint>(i));
        s.goal = goal.goal.value;
        s.speed = goal.speed_limit.value;
        s.restarted = false;
        s.torque_limit = s.shuts_off ? 0 : goal.torque_limit.value;
        s.torque = s.torque || goal_write_switches_on;
      }
    }
  }

  void read() {
    ++seen.cycle;
    seen.period_ns = period_ns;
    seen.silent = given_up;
    for (std::size_t i = 0; i < kJoints; ++i) readServo(i);
    BoardSensors& b = seen.board;
    if (!board) return readWithoutBoard();
    if (!board_answers || board_reply_lost) return b.motion.missed();
    b.motion.received();
    b.servo_power = servo_power;
    b.voltage = Volt{volt};
    b.buttons = buttons;
    for (std::size_t a = 0; a < 3; ++a) b.accelerometer[a] = MeterPerSec2{acceleration[a]};
  }

  void readWithoutBoard() {
    seen.board.absent = true;
    board_answers&& servo_power ? seen.bus.received() : seen.bus.missed();
  }

  void readServo(std::size_t i) {
    FakeServo& s = servo[i];
    JointSensors& j = seen.joint[i];
    if (!board_answers || !servo_power || !s.answers) {
      unseen_.set(i);
      j.motion.missed();
      j.polled.missed();
      return;
    }
    j.motion.received();
    const int ticks = ticksFromRad(Rad{s.stuck_at.value_or(s.position) + s.corruption});
    j.position = radFromTicks(ticks);
    s.corruption = 0;
    j.error_bits = s.error_bits;
    if (s.remembers && !s.torque) j.error_bits |= error_bit::kOverload;
    // As the bus does: one in turn, and those that missed an answer.
    if (!s.polled || (seen.cycle % kJoints != i && !unseen_[i])) return j.polled.missed();
    unseen_.reset(i);
    j.polled.received();
    j.temperature = Celsius{s.celsius};
    j.torque_limit = NewtonMeter{s.torque_limit};
    j.goal = Rad{s.goal};
    j.speed_limit = RadPerSec{s.restarted ? 0 : s.speed};
    j.torque_enabled = s.torque;
    j.voltage = Volt{volt};
  }

 public:
  bool power_obeys = true;              // false: the power switch is defect
  bool goal_write_switches_on = false;  // as real servos do; off, so that the switch itself is tested
};

}  // namespace darwinop
