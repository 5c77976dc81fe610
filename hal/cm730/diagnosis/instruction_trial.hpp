// Tests the instructions that the loop depends on: BULK_READ of board and servos, SYNC_WRITE.
#pragma once

#include "hal/byte_line.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// Fills `facts.instructions` and the results of each readable servo. Changes only the servos' LEDs, for the duration
/// of three exchanges, and restores them.
void tryInstructions(ByteLine& line, RobotFacts& facts);

}  // namespace darwinop::cm730
