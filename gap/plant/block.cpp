#include "gap/plant/block.hpp"

#include <array>

namespace darwinop::gap {

std::string_view name(Block block) {
  static constexpr std::array<std::string_view, kBlocks> kNames{"command", "controller", "supply", "plant", "sensor"};
  return kNames[static_cast<std::size_t>(block)];
}

Block blockOf(twin::Place place) {
  switch (place) {
    case twin::Place::kCommand:
      return Block::kCommand;
    case twin::Place::kController:
      return Block::kController;
    case twin::Place::kSupply:
      return Block::kSupply;
    case twin::Place::kSensor:
      return Block::kSensor;
    case twin::Place::kMotor:
    case twin::Place::kFriction:
    case twin::Place::kTransmission:
    case twin::Place::kLoad:
      return Block::kPlant;
  }
  return Block::kPlant;
}

}  // namespace darwinop::gap
