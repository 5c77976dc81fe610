// Bounds of the cycle numbers and times that a server may send, so that no sum of them overflows.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/sensors.hpp"

namespace darwinop::remote {

/// The image's numbers are within 146 years in ns, and within the cycles of them.
constexpr bool isInBounds(const Sensors& seen) {
  constexpr std::int64_t kMaxTimeNs = std::int64_t{1} << 61;
  constexpr std::uint64_t kMaxCycle = std::uint64_t{1} << 61;
  return seen.cycle <= kMaxCycle && seen.time_ns >= -kMaxTimeNs && seen.time_ns <= kMaxTimeNs;
}

/// The product of the cycles between two images and the longest period, 1 s, fits into 64 bits of ns.
constexpr bool isJumpInBounds(const Sensors& before, const Sensors& after) {
  constexpr std::uint64_t kMaxJump = std::uint64_t{1} << 32;
  return std::max(before.cycle, after.cycle) - std::min(before.cycle, after.cycle) <= kMaxJump;
}

}  // namespace darwinop::remote
