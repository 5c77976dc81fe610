// Findings about the board and the supply.
#pragma once

#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// One row if there is no board that can be read.
void addBoardRows(const RobotFacts& facts, Findings& rows);

}  // namespace darwinop::cm730
