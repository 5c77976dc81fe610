// Names of the blocks of the control loop.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

std::string_view name(LoopPart part) {
  constexpr std::array<std::string_view, 8> kNames{"command",  "controller",   "supply", "motor",
                                                   "friction", "transmission", "load",   "sensor"};
  return kNames[static_cast<std::size_t>(part)];
}

}  // namespace darwinop::twin
