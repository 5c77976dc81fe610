// Is the robot where a controller expects it to begin? Asked on every way to a robot on a serial line.
#pragma once

#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::connect {

/// A robot in another pose is not a fault, as the loop moves it slowly; but somebody should look first. Each joint that
/// is off is named, with how much.
cm730::Findings startPoseFindings(const cm730::RobotFacts& facts);

}  // namespace darwinop::connect
