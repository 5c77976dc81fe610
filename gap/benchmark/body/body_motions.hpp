// The ten recordings of a case of the whole robot: setups and commands.
#pragma once

#include <cstdint>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

/// On the floor: squats, a sway and walks; or bows by the ankles until the robot falls, each way twice.
enum class FloorMotions : std::uint8_t { kWalks, kBows };

/// Clamped: sines twice, triangles with less gain, arms that are released; squats, a walk, lying. Held out: steps, a
/// sway, another walk. Nothing is measured yet. The same for the same seed.
BodyCase plannedBody(const std::string& name, std::uint64_t seed, FloorMotions on_floor = FloorMotions::kWalks);

}  // namespace darwinop::gap
