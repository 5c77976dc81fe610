// What a probe has measured of a robot: figures only, no judgement.
#pragma once

#include <array>
#include <cstdint>
#include <string>

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

struct ServoFacts {
  bool found = false;     // answers to a ping
  bool garbled = false;   // bytes came that were no answer
  bool readable = false;  // true: all that follows down to `position` is known
  std::uint16_t model = 0;
  std::uint8_t firmware = 0, status_level = 0, error_bits = 0;
  std::uint8_t return_delay = 0;  // counts of 2 us
  bool wheel_mode = false;        // both angle limits 0: goals are not obeyed
  bool torque_on = false;
  std::uint16_t torque_limit = 0;  // counts
  Volt voltage;
  Celsius temperature;
  Rad position;

  Mending delay_mending = Mending::kNotNeeded, level_mending = Mending::kNotNeeded;
  std::uint8_t return_delay_was = 0;  // before mending
  int reads = 0, losses = 0;          // single reads, not repeated
};

struct BoardFacts {
  bool found = false, garbled = false, readable = false;
  std::uint16_t model = 0;
  std::uint8_t firmware = 0;
  bool power_was_on = false, power_on = false;  // of the servos
  Volt voltage;
  std::array<MeterPerSec2, 3> accelerometer;  // x, y, z
};

struct RobotFacts {
  std::string port;   // for the sentences
  bool lost = false;  // the line went away in the middle
  BoardFacts board;
  std::array<ServoFacts, kJoints> servo;
  Nanos round_trip{0};       // median of short reads, request to last byte
  int round_trip_reads = 0;  // that were answered; 0: not measured
  Nanos took{0};
};

}  // namespace darwinop::cm730
