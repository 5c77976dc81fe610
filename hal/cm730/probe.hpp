// Measures a robot at start-up: board, servo power, round trip, every servo, the loop's instructions, losses. Nothing
// moves; the servos' LEDs flicker once.
#pragma once

#include <bitset>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/finding.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/cm730/robot_facts.hpp"

namespace darwinop::cm730 {

struct ProbeOptions {
  std::string port = "/dev/ttyUSB0";  // for the sentences only
  /// Write return delay 0 and status level 2 into servos that have something else, and only into those.
  bool correct = true;
  int round_trip_reads = 9;
  int loss_reads_per_servo = 3;
  Nanos loss_budget{300'000'000};  // no more loss reads are begun after this time
  JointOffsets offsets{};          // taken off the positions
  Nanos period{16'000'000};        // of the loop that is to be started
  std::bitset<kJoints> absent{};   // not asked
  TickRanges allowed = tableRanges();

  /// Before a loop: well under a second on a healthy robot, 300 ms more when servo power was off.
  static ProbeOptions quick() { return {}; }
  /// For darwinop-doctor: looks longer, changes nothing but servo power.
  static ProbeOptions thorough() {
    ProbeOptions options;
    options.correct = false;
    options.round_trip_reads = 21;
    options.loss_reads_per_servo = 25;
    options.loss_budget = std::chrono::seconds{4};
    return options;
  }
};

/// Switches servo power on if it is off (torque stays off, nothing moves).
RobotFacts measure(ByteLine& line, const ProbeOptions& options);

struct ProbeReport {
  RobotFacts facts;
  Findings findings;  // board first, then the servos by id, then the line
};
ProbeReport probe(ByteLine& line, const ProbeOptions& options = ProbeOptions::quick());

}  // namespace darwinop::cm730
