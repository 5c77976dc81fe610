// Commands in the logs of a synthetic case: the motions that excite most of a servo's effects in a minute.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "core/random.hpp"

namespace darwinop::gap {

enum class ExcitationMotion : std::uint8_t { kSlowTriangle, kSteps, kMultisine, kBang, kRelease, kChirp, kMoves };
/// As a case calls it: "slow_tri".
std::string_view nameOf(ExcitationMotion motion);

inline constexpr double kHostPeriod = 0.016;  // s, of reads and commands

/// One value a row.
struct CommandSeries {
  std::vector<double> goal_rad;  // whole steps of the encoder
  std::vector<std::uint8_t> torque_on;
};

/// `held_out`: the variant for held-out logs; `rng` draws the rest.
CommandSeries commandsOf(ExcitationMotion motion, bool held_out, Rng& rng);

}  // namespace darwinop::gap
