// A number with its unit, as a model file has it: "1.786 N m/A", "none", "0.01, 0, -0.02 rad/s".
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace darwinop::twin {

/// What may be written for one number.
struct NumberRule {
  std::string_view unit;  // empty: a pure number
  double low = 0, high = 0;
  bool may_be_none = false;  // "none", infinity inside, where it means "no limit"
};

/// Both throw std::runtime_error, a sentence that says what is allowed.
double readNumber(std::string_view text, const NumberRule& rule);
/// x, y, z, and the unit once, at the end.
std::array<double, 3> readAxes(std::string_view text, const NumberRule& rule);

/// The shortest text that gives the same number to the last bit.
std::string writeNumber(double value, const NumberRule& rule);
std::string writeAxes(const std::array<double, 3>& values, const NumberRule& rule);

/// "0 to 0.3 N m", "0.1 to 100000 rad/s2, or none for no limit".
std::string allowed(const NumberRule& rule);

}  // namespace darwinop::twin
