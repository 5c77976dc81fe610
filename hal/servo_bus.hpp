// All that the loop knows about hardware: one write and one read a cycle.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "core/joints.hpp"
#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "core/units.hpp"

namespace darwinop {

/// What one servo said in this cycle. Fields count only when `answered` (and, below the line, `looked`) is true.
struct ServoReading {
  bool answered = false;
  Rad position;
  RadPerSec velocity;
  double load = kUnknown;
  std::uint8_t error_bits = 0;
  // -- in the cycle in which it is this servo's turn:
  bool looked = false;
  bool torque_enabled = false;
  NewtonMeter torque_limit;
  Rad goal;               // in its register
  RadPerSec speed_limit;  // in its register; 0 as after power-up: none
  Volt voltage;
  Celsius temperature;
};

struct BoardReading {
  bool answered = false;
  std::array<RadPerSec, 3> gyro;
  std::array<MeterPerSec2, 3> accelerometer;
  std::uint8_t buttons = 0;
  Volt voltage;
  double microphone_left = kUnknown;
  bool servo_power = false;
  std::uint8_t led_panel = 0;
  std::uint16_t led_head = 0, led_eye = 0;
  std::uint8_t error_bits = 0;
};

struct BusReadings {
  std::array<ServoReading, kJoints> servo{};
  BoardReading board{};
  WireFigures wire{};
  LinkCounters link{};
  std::bitset<kJoints> silent;  // left out of the list, asked again now and then

  /// Nothing has answered. Fields that do not count then keep what they held.
  void forget() noexcept {
    for (ServoReading& one : servo) one.answered = one.looked = false;
    board.answered = false;
  }
};

/// Called by the loop's thread only. Blocks no longer than wire time plus the link's margin.
class ServoBus {
 public:
  virtual ~ServoBus() = default;
  /// At most one SyncWrite, and seldom one write to the board (LEDs, servo power).
  virtual void write(const SafeCommands& commands) noexcept = 0;
  /// One BulkRead. `readings` is overwritten whole: what did not answer is absent.
  virtual void read(BusReadings& readings) noexcept = 0;
};

}  // namespace darwinop
