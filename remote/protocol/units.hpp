// Conversion between wire units and SI units. The server truncates towards zero, as that of 2013 does, and so do the
// clients of 2013; the client of this project rounds (remote/client/command_delta.cpp).
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/conversions.hpp"

namespace darwinop::remote {

/// Unknown value in a reply. The 2013 protocol does not define one; no count, angle or torque has this value.
inline constexpr std::int32_t kNoValue = std::numeric_limits<std::int32_t>::min();

/// Truncates towards zero; NaN and overflow become kNoValue, as the conversion of x86 processors does.
inline std::int32_t cut(double value) {
  return std::abs(value) < 2147483648.0 ? static_cast<std::int32_t>(value) : kNoValue;
}

// Client to server; the first two as clients of 2013.
inline std::int32_t wireFromPosition(double rad) {
  return cut(rad * 2048.0 / kPi);  // 0 is the centre, 1 is 1.534 mrad
}
inline std::int32_t wireFromVelocity(double rad_per_s) {
  return cut(rad_per_s * 30.0 / (kRpmPerCount * kPi));
}

constexpr double positionFromWire(std::int32_t wire) {
  return kPi * wire / 2048.0;
}
/// Range of the encoder; the 2013 server ignores other values.
constexpr bool isEncoderPosition(std::int32_t wire) {
  return wire >= -2048 && wire <= 2047;
}
constexpr double velocityFromWire(std::int32_t wire) {
  return wire * kRpmPerCount * kPi / 30.0;
}
/// -1 means no limit. The 2013 server cut to whole numbers: 0.5 became 0, there the slowest ramp, here none.
constexpr double accelerationFromWire(std::int32_t wire) {
  return wire / 100000.0;
}
constexpr double torqueFromWire(std::int32_t wire) {
  return wire * kMaxTorqueNm / kTorqueMax;
}
constexpr double gainFromWire(std::int32_t wire) {
  return 0.001 * wire;
}

// Server to client.
inline std::int32_t wireFromMeasuredPosition(double rad) {
  return cut(rad * 10000.0);
}
inline std::int32_t wireFromMeasuredTorque(double newton_meter) {
  return cut(newton_meter * 10000.0);
}
/// Position in rad or torque in N m; NaN if unknown.
constexpr double measuredFromWire(std::int32_t wire) {
  return wire == kNoValue ? std::numeric_limits<double>::quiet_NaN() : wire / 10000.0;
}

}  // namespace darwinop::remote
