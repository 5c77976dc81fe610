// Explains silent servos: broken chains, duplicate and wrong ids, defects.
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <vector>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/bus_faults.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// A fault with its place; the texts replace the words of the same names in kBusFaultTable.
struct FaultPlace {
  BusFault fault{};
  std::bitset<kJoints> joints;
  std::string evidence{};
  std::optional<Joint> other{};
  std::string other_text{}, from_text{};
};

/// Places of the faults chain_broken, duplicate_id, wrong_id and servo_silent. Requires servo power.
std::vector<FaultPlace> explainSilentServos(const RobotFacts& facts);

inline std::bitset<kJoints> only(Joint joint) {
  return std::bitset<kJoints>{}.set(index(joint));
}
/// "servo 13 LegLowerR (right knee)", or "servos 13 15 17".
std::string servoNames(const std::bitset<kJoints>& joints);

}  // namespace darwinop::cm730
