// Measurements of a probe, without judgement.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/conversions.hpp"
#include "core/joints.hpp"
#include "core/registers.hpp"
#include "core/units.hpp"
#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/permitted.hpp"

namespace darwinop::cm730 {

/// Outcome of correcting an EEPROM setting.
enum class Correction : std::uint8_t {
  kNotNeeded,
  kDone,      // written and verified
  kNotAsked,  // the probe was read-only
  kTorqueOn,  // an MX-28 accepts EEPROM writes only with torque off
  kRefused,   // written, but reads back unchanged
};

/// A range of positions in servo ticks.
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
  bool absent = false;    // listed as absent in robot.ini: not measured
  bool found = false;     // answers a ping
  bool garbled = false;   // received bytes that are not a valid reply
  bool readable = false;  // true: all fields down to `position` are valid
  std::uint16_t model = 0;
  std::uint8_t firmware = 0, status_level = 0, error_bits = 0;
  std::uint8_t return_delay = 0;                     // counts of 2 us
  std::uint16_t cw_limit = 0, ccw_limit = kTickMax;  // registers 6 and 8
  bool torque_on = false, led_on = false;
  // Of an MX-64 or MX-106: register 10 is not 0, or register 70 is 1 or could not be read.
  bool slave_mode = false, torque_control = false;
  std::uint16_t max_torque = 0, torque_limit = 0;  // counts; EEPROM and RAM
  Volt voltage;
  Celsius temperature;
  Rad position;
  double load = 0;  // -1..1 of the maximum torque as the servo reports it, counter-clockwise positive

  Correction delay_correction = Correction::kNotNeeded, level_correction = Correction::kNotNeeded;
  std::uint8_t return_delay_was = 0;  // before the correction
  bool was_mute = false;              // answered pings only until its status return level was corrected
  int reads = 0, losses = 0;          // single reads without retries
  // Measured by the doctor only (observation.hpp).
  int long_reads = 0, long_losses = 0;  // reads of the whole table, without retries
  int late_answers = 0;                 // answered pings of a servo that was silent at first
  bool restarted = false;               // its torque went off during the observation
  // Instructions as the loop uses them; true also if not tested.
  bool bulk_read_works = true, sync_write_works = true;

  /// Both limits 0: the servo turns continuously at the speed in register 32, and goals do not stop it.
  [[nodiscard]] bool wheelMode() const { return cw_limit == 0 && ccw_limit == 0; }
  [[nodiscard]] bool multiTurnMode() const { return cw_limit == kTickMax && ccw_limit == kTickMax; }
};

struct BoardFacts {
  bool absent = false;  // none answers, and robot.ini permits that; the other fields are not measured
  bool found = false, garbled = false, readable = false;
  int ping_tries = 0;         // until the first answer
  int servos_without_it = 0;  // that answer a ping although the board does not
  std::uint16_t model = 0;
  std::uint8_t firmware = 0;
  bool power_was_on = false, power_on = false;  // servo power
  Volt voltage;
  std::array<MeterPerSec2, 3> accelerometer;  // x, y, z

  /// Measured, or known not to be there.
  [[nodiscard]] bool isKnown() const { return absent || readable; }
  /// Servos can be measured. Without a board their power is unknown until they answer.
  [[nodiscard]] bool suppliesServos() const { return absent || power_on; }
};

/// Results of testing the loop's instructions.
struct InstructionFacts {
  bool tried = false;       // false: no servo to test with; the other fields are invalid
  bool bulk_read = false;   // answered by the board; without a board by a servo
  bool first_lost = false;  // the first BULK_READ got no answer, a later one did
  bool sync_write = false;  // executed by at least one servo
  bool all_blocks =
      true;  // lengths 30..57, of a servo 21..44, by which the bus distinguishes replies (request_tag.hpp)
};

/// Results of the doctor's longer observation (observation.hpp); a start of a loop does not make it.
struct ObservedFacts {
  bool done = false;                    // false: the other fields are not valid
  int foreign_frames = 0;               // valid frames that no request of this program asked for
  int power_losses = 0;                 // times that servo power was on and found off later
  std::vector<std::uint8_t> stray_ids;  // answering ids that no servo of this robot has
};

/// Short reads, from the request to the last byte.
struct RoundTrip {
  int reads = 0;  // answered at the first attempt; 0: not measured, and the times are not valid
  Nanos shortest{0}, median{0};
  Nanos high{0};  // 90th percentile
};

struct RobotFacts {
  std::string port;                    // for messages
  Nanos period{16'000'000};            // period of the loop
  TickRanges allowed = tableRanges();  // allowed goals: joint table, settings and offsets
  std::array<int, kJoints> start{};    // start pose in servo ticks
  Permitted permitted{};
  bool lost = false;  // the line was lost during the measurement
  BoardFacts board;
  std::array<ServoFacts, kJoints> servo;
  InstructionFacts instructions;
  ObservedFacts observed;
  RoundTrip round_trip;
  Nanos took{0};
};

}  // namespace darwinop::cm730
