// Physical quantities as types: mixing units does not compile.
#pragma once

#include <compare>
#include <limits>
#include <numbers>

namespace darwinop {

/// A number with a unit. `Tag` distinguishes the quantity; construction is explicit, arithmetic uses `value`. A
/// default-constructed quantity is NaN (unknown), never zero.
template <class Tag>
struct Unit {
  double value = std::numeric_limits<double>::quiet_NaN();

  constexpr Unit() = default;
  constexpr explicit Unit(double v) : value{v} {}
  constexpr auto operator<=>(const Unit&) const = default;
  /// False for NaN.
  [[nodiscard]] constexpr bool known() const { return value == value; }
};

using Rad = Unit<struct RadTag>;                    // rad, positive as the servo counts up
using RadPerSec = Unit<struct RadPerSecTag>;        // rad/s
using NewtonMeter = Unit<struct NewtonMeterTag>;    // N m
using Volt = Unit<struct VoltTag>;                  // V
using Celsius = Unit<struct CelsiusTag>;            // deg C
using MeterPerSec2 = Unit<struct MeterPerSec2Tag>;  // m/s2

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadPerDegree = kPi / 180.0;
inline constexpr double kRadPerSecPerRpm = 2 * kPi / 60;
/// m/s2, standard gravity. The twin's body file keeps MuJoCo's 9.81.
inline constexpr double kGravity = 9.80665;

}  // namespace darwinop
