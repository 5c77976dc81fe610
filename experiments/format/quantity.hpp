// Numbers with units in experiment files: "90 deg", "0.5 rad/s". The unit is required.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace darwinop::experiments {

struct Quantity {
  std::string_view what;                    // "an angle"
  std::span<const std::string_view> units;  // the first is SI; "" for a dimensionless number
  double low, high;                         // allowed, in the first unit
};

extern const Quantity kAngle, kDistance, kDuration, kSpeed, kAcceleration, kTorque, kTorqueLimit, kFrequency, kGain;

/// Returns the value in the first unit of `quantity`. Throws std::runtime_error with units and allowed range.
double parseNumber(std::string_view text, const Quantity& quantity);

/// "1 rad, 50 deg". Never empty.
std::vector<double> parseNumbers(std::string_view text, const Quantity& quantity);

/// Splits at commas and trims blanks.
std::vector<std::string_view> splitList(std::string_view text);

/// " (did you mean velocity?)" if one of `known` is close to `text`, else empty.
std::string didYouMean(std::string_view text, const std::vector<std::string_view>& known);

/// Four significant digits, for messages: "1.571", "-0.05", "20".
std::string shortText(double value);

}  // namespace darwinop::experiments
