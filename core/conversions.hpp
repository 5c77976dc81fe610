// Exact conversions between register counts and SI units, for the runtime and the virtual robot.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/servo_limits.hpp"
#include "core/units.hpp"

namespace darwinop {

/// Nearest integer, ties to even, as std::nearbyint() by default: adding 1.5 * 2^52 leaves no bits for a fraction. From
/// 2^51 on it may be off by one; results are clamped to a register range afterwards.
constexpr double nearestWhole(double value) {
  constexpr double kNoFraction = 6755399441055744.0;
  return value + kNoFraction - kNoFraction;
}

/// `value` rounded to the nearest whole number and clamped; NaN becomes `low`.
constexpr int nearestWithin(double value, double low, double high) {
  return static_cast<int>(std::min(std::max(low, nearestWhole(value)), high));
}

/// Ticks to rad; exact. Any integer is allowed: a difference of ticks converts with `ticks * kRadPerTick`.
constexpr Rad radFromTicks(int ticks) {
  return Rad{(ticks - kTickCentre) * kRadPerTick};
}

/// Nearest tick, clamped to 0..4095. The argument must be finite.
inline int ticksFromRad(Rad angle) {
  return nearestWithin(angle.value / kRadPerTick, -kTickCentre, kTickMax - kTickCentre) + kTickCentre;
}

/// Present speed register (38): ten bits of magnitude, bit 10 set when turning clockwise.
constexpr RadPerSec velocityFromRegister(std::uint16_t raw) {
  const double magnitude = (raw & 1023) * kRadPerSecPerCount;
  return RadPerSec{(raw & 1024) != 0 ? -magnitude : magnitude};
}

/// Inverse of velocityFromRegister, saturating at 1023 counts.
inline std::uint16_t registerFromVelocity(RadPerSec velocity) {
  const auto magnitude =
      static_cast<std::uint16_t>(nearestWithin(std::abs(velocity.value) / kRadPerSecPerCount, 0, kSpeedMax));
  return velocity.value < 0 && magnitude > 0 ? static_cast<std::uint16_t>(magnitude | 1024) : magnitude;
}

/// Moving speed register (32): 1..1023; 0 would mean "no limit", so a limit never becomes 0.
inline std::uint16_t registerFromSpeedLimit(RadPerSec limit) {
  return static_cast<std::uint16_t>(nearestWithin(std::abs(limit.value) / kRadPerSecPerCount, 1, kSpeedMax));
}

/// Present load register (40): fraction of the maximum torque, -1..1, positive when pushing counter-clockwise.
constexpr double loadFromRegister(std::uint16_t raw) {
  const double magnitude = (raw & 1023) / 1023.0;
  return (raw & 1024) != 0 ? -magnitude : magnitude;
}

inline std::uint16_t registerFromLoad(double load) {
  const auto magnitude = static_cast<std::uint16_t>(nearestWithin(std::abs(load) * 1023.0, 0, 1023));
  return load < 0 && magnitude > 0 ? static_cast<std::uint16_t>(magnitude | 1024) : magnitude;
}

/// Torque limit register (34), 0..1023 for 0..2.5 N m; clamped.
inline std::uint16_t registerFromTorque(NewtonMeter torque) {
  return static_cast<std::uint16_t>(nearestWithin(torque.value / kMaxTorqueNm * kTorqueMax, 0, kTorqueMax));
}

constexpr NewtonMeter torqueFromRegister(std::uint16_t raw) {
  return NewtonMeter{(raw & 1023) * kMaxTorqueNm / kTorqueMax};
}

inline constexpr double kRegisterPerKp = 1 / kGainPerCount;

/// P gain register (28), 0..254.
inline std::uint8_t registerFromPGain(double kp) {
  return static_cast<std::uint8_t>(nearestWithin(kp * kRegisterPerKp, 0, kMaxPGain * kRegisterPerKp));
}

/// Registers in tenths of a volt (MX-28 42, CM-730 50).
constexpr Volt voltFromRegister(std::uint8_t raw) {
  return Volt{raw * 0.1};
}

}  // namespace darwinop
