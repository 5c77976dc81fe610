// Names the fault behind the findings of a check.
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <vector>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/bus_faults.hpp"
#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

struct NamedFault {
  BusFault fault{};
  std::bitset<kJoints> joints;  // the servos concerned; of a break: the first behind it. None: board, port or line
  std::optional<Joint> other;   // duplicate_id: who has the id; swapped: the second one
  std::string what, remedy;     // from kBusFaultTable, with names
  std::string evidence;         // what was measured
};

/// The faults that explain the findings, the most probable first; empty: no fault of port, board, servos or cables.
/// `findings` of all parts of the check; `facts` with an observation, else some faults are not recognized.
///
/// What looks the same on the bus has one name. Consecutive silent servos up to the end of a chain: a broken cable, not
/// as many defects. One silent servo: servo_silent, for a defect as for another baud rate. Exchanged servos are
/// recognized in the start pose, or by an angle outside their joint's range; not if their start angles are alike.
std::vector<NamedFault> nameFaults(const RobotFacts& facts, const Findings& findings);

/// The same format as toText(Finding).
std::string toText(const NamedFault& fault);

}  // namespace darwinop::cm730
