// Units of columns: one row each.
#include "experiments/logs/units.hpp"

#include <algorithm>
#include <array>

namespace darwinop::logs {
namespace {

constexpr auto kUnits = std::to_array<Unit>({
    {"s", "s"},         {"ms", "ms"},     {"us", "us"},         {"rad", "rad"},
    {"rad/s", "rad_s"}, {"deg", "deg"},   {"rad/s2", "rad_s2"}, {"rpm", "rpm"},
    {"deg/s", "deg_s"}, {"N m", "Nm"},    {"N", "N"},           {"N m s/rad", "Nms_rad"},
    {"V", "V"},         {"A", "A"},       {"W", "W"},           {"ohm", "ohm"},
    {"degC", "C"},      {"%", "pct"},     {"m", "m"},           {"mm", "mm"},
    {"m/s", "m_s"},     {"m/s2", "m_s2"}, {"kg", "kg"},         {"kg m2", "kgm2"},
    {"Hz", "Hz"},       {"tick", "tick"}, {"Kp", "Kp"},
});

/// Where the longest suffix that is a unit begins, its underscore included.
std::size_t endOfName(std::string_view name, const Unit** found) {
  for (std::size_t at = name.find('_'); at != std::string_view::npos; at = name.find('_', at + 1)) {
    const auto unit =
        std::find_if(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.suffix == name.substr(at + 1); });
    if (unit == kUnits.end()) continue;
    *found = &*unit;
    return at;
  }
  return name.size();
}

}  // namespace

bool isUnit(std::string_view symbol) {
  return std::any_of(kUnits.begin(), kUnits.end(), [&](const Unit& u) { return u.symbol == symbol; });
}

std::string_view unitOfSuffix(std::string_view name) {
  const Unit* unit = nullptr;
  endOfName(name, &unit);
  return unit == nullptr ? "" : unit->symbol;
}

std::string_view withoutSuffix(std::string_view name) {
  const Unit* unit = nullptr;
  return name.substr(0, endOfName(name, &unit));
}

std::optional<double> secondsIn(std::string_view symbol) {
  if (symbol == "s") return 1.0;
  if (symbol == "ms") return 1e-3;
  if (symbol == "us") return 1e-6;
  return std::nullopt;
}

std::string unitNames() {
  std::string names;
  for (const Unit& unit : kUnits) names.append(names.empty() ? "" : ", ").append(unit.symbol);
  return names;
}

}  // namespace darwinop::logs
