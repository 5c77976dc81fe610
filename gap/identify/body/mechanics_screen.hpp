// A linear screen of all effects of joints and links: what one simulation of each promises.
#pragma once

#include "gap/identify/body/mechanics_fit.hpp"

namespace darwinop::gap {

struct MechanicsCandidate {
  PlacedMechanics placed;     // with the values to start from
  double predicted_gain = 0;  // of the cost
};

/// kAllJoints: an effect that all joints have, which takes a fifth of the time.
enum class ScreenedPlaces : std::uint8_t { kAny, kAllJoints };

/// Of the effects in these limbs beside those that are `found`, in one joint, a pair and all; best first. A pair needs
/// both of its limbs, all joints need all limbs.
std::vector<MechanicsCandidate> screenMechanics(const ClampedRobot& robot, const std::vector<std::size_t>& limbs,
                                                const std::vector<PlacedMechanics>& found, ScreenedPlaces places);

}  // namespace darwinop::gap
