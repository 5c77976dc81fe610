// Numbers with units in a model file: "1.786 N m/A", "none", "0.01, 0, -0.02 rad/s".
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace darwinop::twin {

/// Unit and allowed range of a number.
struct NumberRule {
  std::string_view unit;  // empty: dimensionless
  double low = 0, high = 0;
  bool may_be_none = false;  // accepts "none", stored as infinity: no limit
};

/// Both throw std::runtime_error with the allowed range.
double readNumber(std::string_view text, const NumberRule& rule);
/// Three numbers x, y, z, with one unit at the end.
std::array<double, 3> readAxes(std::string_view text, const NumberRule& rule);

/// The shortest text that reads back as the same double.
std::string writeNumber(double value, const NumberRule& rule);
std::string writeAxes(const std::array<double, 3>& values, const NumberRule& rule);

/// "0 to 0.3 N m", "0.1 to 100000 rad/s2, or none for no limit".
std::string allowed(const NumberRule& rule);

}  // namespace darwinop::twin
