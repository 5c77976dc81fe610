// Resistance of the battery and of the cables that all servos share: the board's voltage against the current that the
// servos draw.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gap/case/body/body_case.hpp"

namespace darwinop::gap {

inline constexpr std::string_view kBatteryResistance = "battery_resistance";  // id of the effect

struct FoundBattery {
  double resistance_ohm = 0, sigma_ohm = 0;
  double sag_v = 0;      // greatest
  double remains_v = 0;  // rms of what it does not explain
};

/// Logs that are not held out, law voltage_p. Nothing: there is no evidence for it, or held-out logs contradict it.
std::optional<FoundBattery> identifyBattery(const BodyCase& given);

std::string asText(const FoundBattery& found);
nlohmann::ordered_json effectJson(const FoundBattery& found);

}  // namespace darwinop::gap
