// Checks at start-up whether the robot is in the start pose; for every robot on a serial line.
#pragma once

#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"
#include "safety/config.hpp"

namespace darwinop::connect {

/// Another pose is a warning, not an error: the loop moves the robot slowly, but the user should look first. Lists each
/// joint that is off, with its deviation.
cm730::Findings startPoseFindings(const cm730::RobotFacts& facts, const safety::Config& safety = {});

}  // namespace darwinop::connect
