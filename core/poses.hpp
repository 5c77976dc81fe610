// Poses of all joints, in ticks; index: servo id - 1. The start pose is a column of core/joints.hpp.
#pragma once

#include <array>
#include <cstdint>

#include "core/joints.hpp"

namespace darwinop {

/// Ready to walk: knees bent, soles flat, arms as in the start pose. Source: page 9 "walkready" of the robot's original
/// motion file; the gait engine at rest gives the same.
inline constexpr std::array<std::uint16_t, kJoints> kWalkReadyTicks{1498, 2518, 1845, 2248, 2381, 1712, 2048,
                                                                    2048, 2052, 2044, 1637, 2459, 2653, 1443,
                                                                    2389, 1707, 2057, 2039, 2048, 2161};

}  // namespace darwinop
