// Start-up measurement of a robot: board, servo power, round trip, every servo, the loop's instructions, losses.
// Nothing moves; the servos' LEDs flash once.
#pragma once

#include <bitset>
#include <functional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/permitted.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"
#include "hal/cm730/joint_offsets.hpp"

namespace darwinop::cm730 {

struct ProbeOptions {
  std::string port = "/dev/ttyUSB0";  // for messages only
  /// Write return delay 0 and status level 2 into supported servos with other values, and only into those.
  bool correct = true;
  /// Also write status level 2 into a servo that answers pings only. Its model can be read only afterwards; register 16
  /// is the status return level of every servo of this protocol.
  bool correct_mute = false;
  int round_trip_reads = 9;
  int loss_reads_per_servo = 3;
  Nanos loss_budget{300'000'000};  // no loss reads start after this time
  JointOffsets offsets{};          // subtracted from positions
  Nanos period{16'000'000};        // period of the loop
  std::bitset<kJoints> absent{};   // not measured
  bool observe = false;            // also what only takes longer to see: observation.hpp
  TickRanges allowed = tableRanges();
  Permitted permitted{};
  std::function<void()> before_servo_power{};  // called if servo power is off, before it is switched on

  /// Start of a loop: well under a second on a healthy robot, 300 ms more if servo power was off.
  static ProbeOptions quick() { return {}; }
  /// For darwinop doctor: measures longer, changes only servo power.
  static ProbeOptions thorough() {
    ProbeOptions options;
    options.correct = false;
    options.round_trip_reads = 21;
    options.loss_reads_per_servo = 25;
    options.loss_budget = std::chrono::seconds{4};
    options.observe = true;
    return options;
  }
};

/// Reads the model of the board and of each servo before anything is written to it. Switches servo power on if it is
/// off (torque stays off, nothing moves).
RobotFacts measure(ByteLine& line, const ProbeOptions& options);

struct ProbeReport {
  RobotFacts facts;
  Findings findings;  // board, then servos by id, then the line
};
ProbeReport probe(ByteLine& line, const ProbeOptions& options = ProbeOptions::quick());

}  // namespace darwinop::cm730
