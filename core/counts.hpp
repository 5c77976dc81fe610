// Raw counts and colour words that controllers of this robot expect. Used only by the Webots API and the remote
// protocol.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/registers.hpp"
#include "core/units.hpp"

namespace darwinop {

inline constexpr Register kGyroRegister = find(kCm730, "gyro_x");  // same scale for all three axes
inline constexpr Register kAccelRegister = find(kCm730, "accel_x");

/// The count that the board sent, 0..1023 (512 at rest), from the SI value; NaN: unknown.
inline double countFrom(double si, const Register& law) {
  return std::round(si / law.scale + law.zero);
}

/// 0xRRGGBB to the board's colour word: bits 0-4 red, 5-9 green, 10-14 blue.
constexpr std::uint16_t rgb15From24(int colour) {
  const int red = (colour >> 16) & 0xFF, green = (colour >> 8) & 0xFF, blue = colour & 0xFF;
  return static_cast<std::uint16_t>(((blue >> 3) << 10) | ((green >> 3) << 5) | (red >> 3));
}

/// Colour word to 0xRRGGBB: 31 becomes 255.
constexpr int rgb24From15(std::uint16_t word) {
  const auto widen = [](int five) { return (five << 3) | (five >> 2); };
  return (widen(word & 31) << 16) | (widen((word >> 5) & 31) << 8) | widen((word >> 10) & 31);
}

}  // namespace darwinop
