// A linear screen of all effects of joints and links: the gain that one simulation of each predicts.
#pragma once

#include "gap/identify/body/mechanics_fit.hpp"

namespace darwinop::gap {

struct MechanicsCandidate {
  PlacedMechanics placed;     // with the values to start from
  double predicted_gain = 0;  // of the cost
};

/// kAny: in one joint of these limbs, or in a pair with both joints in them. kAllJoints: an effect that all joints of
/// the robot have, in a fifth of the time; closed limbs count as well.
enum class ScreenedPlaces : std::uint8_t { kAny, kAllJoints };

/// Effects beside those that are `found`; best first.
std::vector<MechanicsCandidate> screenMechanics(const ClampedRobot& robot, const std::vector<std::size_t>& limbs,
                                                const std::vector<PlacedMechanics>& found, ScreenedPlaces places);

}  // namespace darwinop::gap
