// Numbers with units, as experiment files write them: "90 deg", "0.5 rad/s". A number without its unit is refused.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::experiments {

struct UnitRow {
  std::string_view text;  // "" for a plain number
  double factor;          // to the first unit of the quantity
};

struct Quantity {
  std::string_view what;  // "an angle"
  std::span<const UnitRow> units;
  double low, high;  // allowed, in the first unit
};

extern const Quantity kAngle, kDistance, kDuration, kSpeed, kAcceleration, kTorque, kTorqueLimit, kFrequency, kGain;

/// In the first unit of `quantity`. Throws std::runtime_error with what is allowed.
double parseNumber(std::string_view text, const Quantity& quantity);

/// "1 rad, 50 deg". Never empty.
std::vector<double> parseNumbers(std::string_view text, const Quantity& quantity);

/// The parts of a list with commas, without blanks around them.
std::vector<std::string_view> splitList(std::string_view text);

/// " (did you mean velocity?)" when one of `known` is close to `text`, else empty.
std::string didYouMean(std::string_view text, const std::vector<std::string_view>& known);

/// "a, b, c".
std::string joined(const std::vector<std::string_view>& words);

/// Short, for people: "1.571", "-0.05", "20".
std::string shortText(double value);

}  // namespace darwinop::experiments
