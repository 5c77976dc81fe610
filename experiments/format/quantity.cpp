// Numbers with units, as experiment files write them: "90 deg", "0.5 rad/s". A number without its unit is refused.
#include "experiments/format/quantity.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <stdexcept>

#include "core/text/number_text.hpp"
#include "core/units.hpp"

namespace darwinop::experiments {
namespace {

constexpr UnitRow kAngleUnits[] = {{"rad", 1}, {"deg", kRadPerDegree}};
constexpr UnitRow kTimeUnits[] = {{"s", 1}, {"ms", 1e-3}};
constexpr UnitRow kSpeedUnits[] = {{"rad/s", 1}, {"deg/s", kRadPerDegree}, {"rpm", kPi / 30}};
constexpr UnitRow kAccelerationUnits[] = {{"rad/s2", 1}, {"deg/s2", kRadPerDegree}};
constexpr UnitRow kTorqueUnits[] = {{"N m", 1}, {"mN m", 1e-3}};
constexpr UnitRow kFrequencyUnits[] = {{"Hz", 1}};
constexpr UnitRow kNoUnits[] = {{"", 1}};

std::string unitNames(const Quantity& quantity) {
  std::string names;
  for (const UnitRow& unit : quantity.units) names += (names.empty() ? "" : ", ") + std::string{unit.text};
  return names;
}

/// Letters that have to be changed, added or left out (Levenshtein).
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> line(b.size() + 1);
  std::iota(line.begin(), line.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t corner = line[0];
    line[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = corner + (a[i] == b[j] ? 0 : 1);
      corner = line[j + 1];
      line[j + 1] = std::min({changed, line[j] + 1, line[j + 1] + 1});
    }
  }
  return line.back();
}

}  // namespace

// The limits are those of the servo (0.0119 to 12.21 rad/s, 2.5 N m, P register 254), or what is sensible on a robot.
const Quantity kAngle{"an angle", kAngleUnits, -2 * kPi, 2 * kPi};
const Quantity kDistance{"an angle above 0", kAngleUnits, 0.001, 2 * kPi};
const Quantity kDuration{"a time", kTimeUnits, 0.016, 600};
const Quantity kSpeed{"a speed", kSpeedUnits, 0.0119, 12.22};
const Quantity kAcceleration{"an acceleration", kAccelerationUnits, 0.1, 1000};
const Quantity kTorque{"a torque", kTorqueUnits, -2.5, 2.5};
const Quantity kTorqueLimit{"a torque limit", kTorqueUnits, 0, 2.5};
const Quantity kFrequency{"a frequency", kFrequencyUnits, 0.01, 10};
const Quantity kGain{"a P gain", kNoUnits, 0.125, 31.75};

double parseNumber(std::string_view text, const Quantity& quantity) {
  text = text::withoutBlanks(text);
  const UnitRow* best = nullptr;  // "mN m" ends like "N m": the longest unit that leaves a number counts
  double value = 0;
  for (const UnitRow& unit : quantity.units) {
    if (!text.ends_with(unit.text) || (best && best->text.size() > unit.text.size())) continue;
    const auto number = text::numberFromText(text.substr(0, text.size() - unit.text.size()));
    if (!number) continue;
    best = &unit;
    value = *number * unit.factor;
  }
  const std::string units = unitNames(quantity);
  if (!best)
    throw std::runtime_error("'" + std::string{text} + "' is not " + std::string{quantity.what} + ": write a number" +
                             (units.empty() ? " without a unit" : " and its unit (" + units + ")"));
  if (value < quantity.low || value > quantity.high)
    throw std::runtime_error("'" + std::string{text} + "' is out of range for " + std::string{quantity.what} +
                             ": allowed are " + shortText(quantity.low) + " to " + shortText(quantity.high) + " " +
                             std::string{quantity.units.front().text});
  return value;
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
  const auto nearest =
      std::ranges::min_element(known, {}, [text](std::string_view word) { return distance(text, word); });
  if (nearest == known.end() || distance(text, *nearest) > std::max<std::size_t>(2, nearest->size() / 3)) return {};
  return " (did you mean " + std::string{*nearest} + "?)";
}

std::string joined(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string{word};
  return text;
}

std::string shortText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace darwinop::experiments
