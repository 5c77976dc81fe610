// The six ways in which the owner holds the trunk still, level or plumb.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "hal/cm730/imu_correction.hpp"

namespace darwinop::calibrate {

struct TrunkPosture {
  std::string_view name;
  std::string_view instruction;
  std::array<double, 3> up;  // in the trunk: left, up, forward

  /// What an exact accelerometer reads: right, forward, up, m/s2.
  [[nodiscard]] constexpr cm730::ImuCalibration::Axes gravity() const {
    return {-up[0] * kGravity, up[2] * kGravity, up[1] * kGravity};
  }
};

inline constexpr std::array kPostures{
    TrunkPosture{"upright", "Hold the trunk upright: its left and its forward edges level", {0, 1, 0}},
    TrunkPosture{"back", "Lay the trunk on its back, face up: its shoulders and its length level", {0, 0, 1}},
    TrunkPosture{"front", "Lay the trunk on its front, face down: its shoulders and its length level", {0, 0, -1}},
    TrunkPosture{
        "right side", "Lay the trunk on its right side, left arm up: its length and its forward edge level", {1, 0, 0}},
    TrunkPosture{
        "left side", "Lay the trunk on its left side, right arm up: its length and its forward edge level", {-1, 0, 0}},
    TrunkPosture{"head down", "Hold the trunk upside down: its left and its forward edges level", {0, -1, 0}},
};

}  // namespace darwinop::calibrate
