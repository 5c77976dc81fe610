// Findings about servos, one row each; locates cable breaks when some are silent.
#pragma once

#include <string>

#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

// Notes and remedies that have no kind of their own.
inline constexpr const char* kStatusLevelCorrected = "status return level set to 2 permanently";
inline constexpr const char* kMuteCorrected =
    "at status return level 0 its model could not be read; level set to 2 permanently";
inline constexpr const char* kHowToSupply = "switch the servos' supply on";
inline constexpr const char* kIdOneTwice = "two servos may share id 1";

/// "servo 13 LegLowerR (right knee)"
std::string servoName(Joint joint);

/// What the chains of servos begin at: "the board", "the adapter".
const char* feedName(const BoardFacts& board);

/// Twenty rows by id, or a single one if no servo answers.
void addServoRows(const RobotFacts& facts, Findings& rows);

/// Servos keep their torque when the loop is killed or the computer restarts. One finding, or none; only true while no
/// loop uses the port.
Findings underTorqueRows(const RobotFacts& facts);

}  // namespace darwinop::cm730
