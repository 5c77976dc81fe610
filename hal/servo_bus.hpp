// Interface of the servo bus: one write and one read per cycle.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include "core/joints.hpp"
#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "core/units.hpp"

namespace darwinop {

/// Readings of one servo. Fields are of this cycle if `answered` (below the line: if `polled`) is true, else undefined.
struct ServoReading {
  bool answered = false;
  Rad position;
  RadPerSec velocity;
  double load = kUnknown;
  std::uint8_t error_bits = 0;
  // -- in the cycle of this servo's turn in the round-robin poll:
  bool polled = false;
  bool torque_enabled = false;
  NewtonMeter torque_limit;
  Rad goal;               // goal register
  RadPerSec speed_limit;  // speed register; 0: unlimited, as after power-up
  Volt voltage;
  Celsius temperature;
};

/// Readings of the board. Fields are of this cycle if `answered` is true, else undefined.
struct BoardReading {
  bool absent = false;  // there is none; set in every cycle
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
  bool servos_answered = false;  // without a board: the servo that was read first has answered
  WireFigures wire{};
  LinkCounters link{};
  std::bitset<kJoints> silent;  // omitted from the read list, retried periodically

  /// Clears the flags; all other fields keep their values of earlier cycles.
  void forget() noexcept {
    for (ServoReading& one : servo) one.answered = one.polled = false;
    board.answered = servos_answered = false;
  }
};

/// Called by the loop's thread only. Blocks for at most the wire time plus the link's margin.
class ServoBus {
 public:
  virtual ~ServoBus() = default;
  /// One SyncWrite to the driven servos (two while a servo works at its torque limit and limits change). What the board
  /// is to do (LEDs, servo power) is sent after the replies of read().
  virtual void write(const SafeCommands& commands) noexcept = 0;
  /// One BulkRead. Sets every flag (`answered`, `polled`), and the fields whose flag is true; the others keep the
  /// values of earlier cycles. Also sets `wire`, `link` and `silent`.
  virtual void read(BusReadings& readings) noexcept = 0;
};

}  // namespace darwinop
