// Parses numbers with units: "90 deg", "0.5 rad/s". Also suggestions for misspelled words.
#include "experiments/format/quantity.hpp"

#include <optional>
#include <stdexcept>

#include "core/servo_limits.hpp"
#include "core/text/nearest.hpp"
#include "core/text/number_text.hpp"
#include "core/text/unit_factor.hpp"
#include "core/units.hpp"

namespace darwinop::experiments {
namespace {

constexpr std::string_view kAngleUnits[] = {"rad", "deg"};
constexpr std::string_view kTimeUnits[] = {"s", "ms"};
constexpr std::string_view kSpeedUnits[] = {"rad/s", "deg/s", "rpm"};
constexpr std::string_view kAccelerationUnits[] = {"rad/s2", "deg/s2"};
constexpr std::string_view kTorqueUnits[] = {"N m", "mN m"};
constexpr std::string_view kFrequencyUnits[] = {"Hz"};
constexpr std::string_view kNoUnits[] = {""};

std::string unitNames(const Quantity& quantity) {
  std::string names;
  for (const std::string_view unit : quantity.units) names += (names.empty() ? "" : ", ") + std::string{unit};
  return names;
}

}  // namespace

// Limits of the servo (core/servo_limits.hpp), or reasonable values for the robot.
const Quantity kAngle{"an angle", kAngleUnits, -2 * kPi, 2 * kPi};
const Quantity kDistance{"an angle above 0", kAngleUnits, 0.001, 2 * kPi};
const Quantity kDuration{"a time", kTimeUnits, 0.016, 600};
const Quantity kSpeed{"a speed", kSpeedUnits, kLeastSpeed, kRegisterSpeed};
const Quantity kAcceleration{"an acceleration", kAccelerationUnits, 0.1, 1000};
const Quantity kTorque{"a torque", kTorqueUnits, -kMaxTorqueNm, kMaxTorqueNm};
const Quantity kTorqueLimit{"a torque limit", kTorqueUnits, 0, kMaxTorqueNm};
const Quantity kFrequency{"a frequency", kFrequencyUnits, 0.01, 10};
const Quantity kGain{"a P gain", kNoUnits, kGainPerCount, kMaxPGain};

double parseNumber(std::string_view text, const Quantity& quantity) {
  text = text::withoutBlanks(text);
  std::optional<double> value;
  std::size_t longest = 0;  // "mN m" also ends in "N m": use the longest matching unit
  for (const std::string_view unit : quantity.units) {
    if (!text.ends_with(unit) || unit.size() < longest) continue;
    const auto number = text::numberFromText(text.substr(0, text.size() - unit.size()));
    if (!number) continue;
    longest = unit.size();
    value = *number * text::unitFactor(unit, quantity.units.front()).value();
  }
  const std::string units = unitNames(quantity);
  if (!value)
    throw std::runtime_error("'" + std::string{text} + "' is not " + std::string{quantity.what} + ": write a number" +
                             (units.empty() ? " without a unit" : " and its unit (" + units + ")"));
  if (*value < quantity.low || *value > quantity.high)
    throw std::runtime_error("'" + std::string{text} + "' is out of range for " + std::string{quantity.what} +
                             ": allowed are " + shortText(quantity.low) + " to " + shortText(quantity.high) + " " +
                             std::string{quantity.units.front()});
  return *value;
}

std::vector<double> parseNumbers(std::string_view text, const Quantity& quantity) {
  std::vector<double> values;
  for (const std::string_view part : splitList(text)) values.push_back(parseNumber(part, quantity));
  return values;
}

std::vector<std::string_view> splitList(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    parts.push_back(text::withoutBlanks(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::string didYouMean(std::string_view text, const std::vector<std::string_view>& known) {
  const auto near = text::nearest(text, known);
  return near ? " (did you mean " + std::string{*near} + "?)" : "";
}

std::string shortText(double value) {
  return text::generalText(value, 4);
}

}  // namespace darwinop::experiments
