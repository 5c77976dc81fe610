// Names of the blocks of the control loop.
#include "twin/servo/effect.hpp"

namespace darwinop::twin {

std::string_view name(Place place) {
  constexpr std::array<std::string_view, 8> kNames{"command",  "controller",   "supply", "motor",
                                                   "friction", "transmission", "load",   "sensor"};
  return kNames[static_cast<std::size_t>(place)];
}

}  // namespace darwinop::twin
