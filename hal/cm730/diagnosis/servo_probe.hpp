// Reads the registers of every servo, and corrects return delays and status levels.
#pragma once

#include "hal/cm730/diagnosis/probe.hpp"
#include "hal/cm730/diagnosis/probe_requests.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// Fills `facts.servo` of all servos that are not absent. Writes only with ProbeOptions::correct, and then only to
/// servos of a driven model, or with ProbeOptions::correct_mute to a servo whose model cannot be read.
void measureServos(ProbeRequests& requests, const ProbeOptions& options, RobotFacts& facts);

}  // namespace darwinop::cm730
