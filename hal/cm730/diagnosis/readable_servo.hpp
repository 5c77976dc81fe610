// Findings about a servo whose registers were read.
#pragma once

#include <string>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// Model, firmware, limits, instructions, settings and health, in one row.
Finding readableRow(Joint joint, const RobotFacts& facts);

/// Remedy for a setting that was not corrected; empty if it was.
std::string correctionRemedy(Correction correction);

}  // namespace darwinop::cm730
