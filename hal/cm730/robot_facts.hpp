// What a probe has measured of a robot: figures only, no judgement.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/units.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::cm730 {

/// What became of a setting in a servo's EEPROM that was not as it should be.
enum class Mending : std::uint8_t {
  kNotNeeded,
  kDone,      // written and read back
  kNotAsked,  // the probe was to look only
  kTorqueOn,  // an MX-28 takes EEPROM writes only while its torque is off
  kRefused,   // written, and read back unchanged
};

/// Positions of a servo, in its own ticks.
struct TickRange {
  int low = 0, high = kTickMax;
};
using TickRanges = std::array<TickRange, kJoints>;
constexpr TickRanges tableRanges() {
  TickRanges ranges{};
  for (std::size_t i = 0; i < kJoints; ++i) ranges[i] = {kJointTable[i].low, kJointTable[i].high};
  return ranges;
}

struct ServoFacts {
  bool absent = false;    // robot.ini says that it is not there: it was not asked
  bool found = false;     // answers to a ping
  bool garbled = false;   // bytes came that were no answer
  bool readable = false;  // true: all that follows down to `position` is known
  std::uint16_t model = 0;
  std::uint8_t firmware = 0, status_level = 0, error_bits = 0;
  std::uint8_t return_delay = 0;                     // counts of 2 us
  std::uint16_t cw_limit = 0, ccw_limit = kTickMax;  // registers 6 and 8
  bool torque_on = false, led_on = false;
  std::uint16_t max_torque = 0, torque_limit = 0;  // counts; EEPROM and RAM
  Volt voltage;
  Celsius temperature;
  Rad position;

  Mending delay_mending = Mending::kNotNeeded, level_mending = Mending::kNotNeeded;
  std::uint8_t return_delay_was = 0;  // before mending
  int reads = 0, losses = 0;          // single reads, not repeated
  // As the loop does it; true also when it was not tried.
  bool bulk_read_works = true, sync_write_works = true;

  /// Both limits 0: the servo turns without end at the speed of register 32, and no goal stops it.
  [[nodiscard]] bool wheelMode() const { return cw_limit == 0 && ccw_limit == 0; }
  [[nodiscard]] bool multiTurnMode() const { return cw_limit == kTickMax && ccw_limit == kTickMax; }
};

struct BoardFacts {
  bool found = false, garbled = false, readable = false;
  std::uint16_t model = 0;
  std::uint8_t firmware = 0;
  bool power_was_on = false, power_on = false;  // of the servos
  Volt voltage;
  std::array<MeterPerSec2, 3> accelerometer;  // x, y, z
};

/// Whether the instructions that the loop lives on have an effect.
struct InstructionFacts {
  bool tried = false;       // false: there was nothing to try them on, and all that follows means nothing
  bool bulk_read = false;   // the board answered to one
  bool sync_write = false;  // some servo obeyed one
  bool all_blocks = true;   // of 30..57 bytes, by which the bus tells replies apart (request_tag.hpp)
};

struct RobotFacts {
  std::string port;                    // for the sentences
  Nanos period{16'000'000};            // that the loop is to have
  TickRanges allowed = tableRanges();  // goals that servos can get: joint table, settings and offsets
  std::array<int, kJoints> start{};    // the start pose in servo ticks
  bool lost = false;                   // the line went away in the middle
  BoardFacts board;
  std::array<ServoFacts, kJoints> servo;
  InstructionFacts instructions;
  Nanos round_trip{0};       // median of short reads, request to last byte
  int round_trip_reads = 0;  // that were answered; 0: not measured
  Nanos took{0};
};

}  // namespace darwinop::cm730
