#include "gap/plant/block.hpp"

#include <array>

namespace darwinop::gap {

std::string_view name(Block block) {
  static constexpr std::array<std::string_view, kBlocks> kNames{"command", "controller", "supply", "plant", "sensor"};
  return kNames[static_cast<std::size_t>(block)];
}

Block blockOf(twin::LoopPart part) {
  switch (part) {
    case twin::LoopPart::kCommand:
      return Block::kCommand;
    case twin::LoopPart::kController:
      return Block::kController;
    case twin::LoopPart::kSupply:
      return Block::kSupply;
    case twin::LoopPart::kSensor:
      return Block::kSensor;
    case twin::LoopPart::kMotor:
    case twin::LoopPart::kFriction:
    case twin::LoopPart::kTransmission:
    case twin::LoopPart::kLoad:
      return Block::kPlant;
  }
  return Block::kPlant;
}

}  // namespace darwinop::gap
