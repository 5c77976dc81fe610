// How figures become JSON, for the texts of this room.
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

namespace darwinop::monitor {

using Json = nlohmann::ordered_json;

inline std::string written(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);  // names come from memory that others write
}

/// Five digits behind the point: finer than any count of the robot.
inline Json figure(double value, double digits = 1e5) {
  if (!std::isfinite(value)) return nullptr;
  const double rounded = std::round(value * digits) / digits;
  constexpr double kExact = 9e15;  // doubles count by ones up to here
  if (std::abs(rounded) < kExact && rounded == std::trunc(rounded))
    return static_cast<std::int64_t>(rounded);  // 0, not -0.0
  return rounded;
}

}  // namespace darwinop::monitor
