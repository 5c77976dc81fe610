// Recognizes two servos in each other's place by their angles.
#pragma once

#include <optional>
#include <string>

#include "core/joints.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

struct SwappedPair {
  Joint first{}, second{};
  std::string evidence;
};
/// In the start pose: exactly two joints are elsewhere, each where the other should be. In any pose: exactly two joints
/// are outside their own range and inside each other's. Pairs with similar start angles (hip yaw and roll, ankle roll,
/// left and right) are not recognized unless the pose shows it.
std::optional<SwappedPair> findSwapped(const RobotFacts& facts);

}  // namespace darwinop::cm730
