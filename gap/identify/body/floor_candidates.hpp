// All effects that are looked for in recordings on the floor: those of floor, trunk and moving sensor, and of joints
// that show under the weight of the robot alone.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "gap/identify/body/floor_effect.hpp"

namespace darwinop::gap {

/// Beside floorEffects(), encoder_offset of ankles and feet that have in `about` what the model of the case gives them:
/// what clamped logs have shown stands. Deviations among engines have the priors of the case in them.
std::shared_ptr<const std::vector<FloorEffect>> floorCandidates(const BodyCase& given, const FloorModel& about);

/// Joints of FloorEffect::at, one or both of a pair, "AnkleR AnkleL"; other places as they are.
std::vector<std::string_view> loadedJointsAt(std::string_view at);

}  // namespace darwinop::gap
