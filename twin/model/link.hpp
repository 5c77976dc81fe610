// Links of the body, and what a model file changes in them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "core/joints.hpp"

namespace darwinop::twin {

/// Beside the numbers of the body's file, in the link's frame. The defaults change nothing.
struct LinkSettings {
  double mass_kg = 0;                       // a point mass that is added
  std::array<double, 3> mass_from_com_m{};  // its place, from the link's centre of mass
  std::array<double, 3> com_shift_m{};      // of the link with that mass
  bool operator==(const LinkSettings&) const = default;
};

/// Links are numbered as the joints that move them; the trunk is the last one.
inline constexpr std::size_t kTrunkLink = kJoints, kLinks = kJoints + 1;

/// "ArmLowerR", "Body".
constexpr std::string_view linkName(std::size_t link) {
  return link == kTrunkLink ? std::string_view{"Body"} : std::string_view{kJointTable[link].name};
}

}  // namespace darwinop::twin
