// Tries the instructions that a loop lives on, as it uses them: BULK_READ of board and servos, SYNC_WRITE.
#pragma once

#include "hal/byte_line.hpp"
#include "hal/cm730/robot_facts.hpp"

namespace darwinop::cm730 {

/// Fills `facts.instructions` and what is known of each readable servo. Writes nothing but the servos' LEDs, for as
/// long as three exchanges take, and leaves them as they were.
void tryInstructions(ByteLine& line, RobotFacts& facts);

}  // namespace darwinop::cm730
