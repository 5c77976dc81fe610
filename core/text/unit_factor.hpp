// Conversion of common units to SI units.
#pragma once

#include <optional>
#include <string_view>

#include "core/units.hpp"

namespace darwinop::text {

struct UnitRow {
  std::string_view written, si;
  double factor;
};
inline constexpr UnitRow kUnitTable[] = {
    {"deg", "rad", kRadPerDegree},
    {"degree", "rad", kRadPerDegree},
    {"degrees", "rad", kRadPerDegree},
    {"°", "rad", kRadPerDegree},
    {"deg/s", "rad/s", kRadPerDegree},
    {"°/s", "rad/s", kRadPerDegree},
    {"dps", "rad/s", kRadPerDegree},
    {"deg/s2", "rad/s2", kRadPerDegree},
    {"°/s2", "rad/s2", kRadPerDegree},
    {"rpm", "rad/s", kRadPerSecPerRpm},
    {"arcmin", "rad", kRadPerDegree / 60},
    {"mrad", "rad", 1e-3},
    {"mrad/s", "rad/s", 1e-3},
    {"ms", "s", 1e-3},
    {"us", "s", 1e-6},
    {"mm", "m", 1e-3},
    {"cm", "m", 1e-2},
    {"g", "kg", 1e-3},
    {"g", "m/s2", kGravity},
    {"mN m", "N m", 1e-3},
    {"N mm", "N m", 1e-3},
    {"g cm2", "kg m2", 1e-7},
    {"%", "", 1e-2},
    {"mV", "V", 1e-3},
    {"mA", "A", 1e-3},
    {"mohm", "ohm", 1e-3},
    {"kohm", "ohm", 1e3},
};

/// Factor from unit `written` to unit `si`; nothing if they do not measure the same quantity. "" is the unit of a
/// dimensionless number.
constexpr std::optional<double> unitFactor(std::string_view written, std::string_view si) {
  if (written == si) return 1.0;
  for (const UnitRow& row : kUnitTable)
    if (row.written == written && row.si == si) return row.factor;
  return std::nullopt;
}

}  // namespace darwinop::text
