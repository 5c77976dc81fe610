// Units of columns: "Neck.position [rad]" as the runtime writes it, "pos_rad" as plain CSV files do.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace darwinop::logs {

struct Unit {
  std::string_view symbol;  // in brackets
  std::string_view suffix;  // after an underscore
};

/// "N m" and "N_m" are not the same: only the first is known.
[[nodiscard]] bool isUnit(std::string_view symbol);

/// What the name ends with, "rad/s" for "speed_rad_s"; "" when that is no unit, as in "torque_on".
[[nodiscard]] std::string_view unitOfSuffix(std::string_view name);

/// The name without such an end: "speed" for "speed_rad_s".
[[nodiscard]] std::string_view withoutSuffix(std::string_view name);

/// 0.001 for "ms"; nothing for what is no time.
[[nodiscard]] std::optional<double> secondsIn(std::string_view symbol);

/// All symbols, for an error: "rad, rad/s, …".
[[nodiscard]] std::string unitNames();

}  // namespace darwinop::logs
