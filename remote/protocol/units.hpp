// Between the numbers on the wire and SI units. Both ways cut towards zero, and so lose a little: the clients of 2013
// and of today do the same, and a robot driven by them moves to the last tick as it did.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "core/conversions.hpp"

namespace darwinop::remote {

/// "Not known" in a reply: no count, angle or torque is ever this. The protocol of 2013 has no word for it.
inline constexpr std::int32_t kNoValue = std::numeric_limits<std::int32_t>::min();

/// Cut towards zero; what does not fit, or is no number, becomes kNoValue, as on the clients' processors.
inline std::int32_t cut(double value) {
  return std::abs(value) < 2147483648.0 ? static_cast<std::int32_t>(value) : kNoValue;
}

// Client to server.
inline std::int32_t wireFromPosition(double rad) {
  return cut(rad * 2048.0 / kPi);  // 0 is the centre, 1 is 1.534 mrad
}
inline std::int32_t wireFromVelocity(double rad_per_s) {
  return cut(rad_per_s * 30.0 / (0.114 * kPi));
}
inline std::int32_t wireFromAcceleration(double rad_per_s2) {
  return cut(rad_per_s2 * 100000.0);
}
inline std::int32_t wireFromTorque(double newton_meter) {
  return cut(newton_meter * kTorqueMax / kMaxTorqueNm);
}
inline std::int32_t wireFromGain(double gain) {
  return cut(gain * 1000.0);
}

constexpr double positionFromWire(std::int32_t wire) {
  return kPi * wire / 2048.0;
}
/// An encoder knows no other angle; the old server overhears the others.
constexpr bool isEncoderPosition(std::int32_t wire) {
  return wire >= -2048 && wire <= 2047;
}
constexpr double velocityFromWire(std::int32_t wire) {
  return wire * 0.114 * kPi / 30.0;
}
/// Whole numbers: the old server divides so. -1, no limit, survives; 0.5 becomes 0.
constexpr double accelerationFromWire(std::int32_t wire) {
  const std::int32_t whole = wire / 100000;
  return whole;
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
/// For a position in rad or a torque in N m; NaN for "not known".
constexpr double measuredFromWire(std::int32_t wire) {
  return wire == kNoValue ? std::numeric_limits<double>::quiet_NaN() : wire / 10000.0;
}

}  // namespace darwinop::remote
