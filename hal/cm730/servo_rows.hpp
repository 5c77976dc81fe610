// Findings about servos: one row each, and which cable to look at when some are silent.
#pragma once

#include <string>

#include "hal/cm730/finding.hpp"
#include "hal/cm730/robot_facts.hpp"

namespace darwinop::cm730 {

/// "servo 13 LegLowerR (right knee)"
std::string servoName(Joint joint);

/// Twenty rows by id, or one when none of them answers.
void addServoRows(const RobotFacts& facts, Findings& rows);

}  // namespace darwinop::cm730
