// The blocks of the control loop, and the block in which an effect acts.
#pragma once

#include <cstdint>
#include <string_view>

#include "twin/servo/effect.hpp"

namespace darwinop::gap {

/// In the order in which a goal goes through them.
enum class Block : std::uint8_t { kCommand, kController, kSupply, kPlant, kSensor };
inline constexpr std::size_t kBlocks = 5;

std::string_view name(Block block);
/// The block in which an effect in this part of the loop acts: motor, friction, gear train and load are the plant.
Block blockOf(twin::LoopPart part);

}  // namespace darwinop::gap
