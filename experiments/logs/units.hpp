// Units of columns: "Neck.position [rad]" in recordings, "pos_rad" in plain CSV files.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace darwinop::logs {

struct ColumnUnit {
  std::string_view symbol;  // in brackets
  std::string_view suffix;  // after an underscore
};

/// Exact match: "N m" is known, "N_m" is not.
[[nodiscard]] bool isUnit(std::string_view symbol);

/// Unit of the name's suffix, "rad/s" for "speed_rad_s"; "" without one, as in "torque_on".
[[nodiscard]] std::string_view unitOfSuffix(std::string_view name);

/// The name without the unit suffix: "speed" for "speed_rad_s".
[[nodiscard]] std::string_view withoutSuffix(std::string_view name);

/// 0.001 for "ms"; empty for a unit that is not time.
[[nodiscard]] std::optional<double> secondsIn(std::string_view symbol);

/// All symbols, for messages: "rad, rad/s, …".
[[nodiscard]] std::string unitNames();

}  // namespace darwinop::logs
