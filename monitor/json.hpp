// JSON helpers for the messages of the monitor.
#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "core/json/json_text.hpp"

namespace darwinop::monitor {

using Json = nlohmann::ordered_json;

/// Rounded to five decimals, finer than the resolution of any sensor; null if not finite.
inline Json rounded(double value, double digits = 1e5) {
  if (!std::isfinite(value)) return nullptr;
  const double result = std::round(value * digits) / digits;
  constexpr double kExact = 9e15;  // doubles represent every integer up to here
  if (std::abs(result) < kExact && result == std::trunc(result))
    return static_cast<std::int64_t>(result);  // 0, not -0.0
  return result;
}

}  // namespace darwinop::monitor
