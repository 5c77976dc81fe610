// A log as BAM writes it.
#pragma once

#include <cmath>
#include <functional>
#include <string>

namespace darwinop::gap {

inline std::string zero(int) {
  return "0";
}

/// A log of 200 rows; `load` and `torque` are texts of numbers by row.
inline std::string bamText(const std::function<std::string(int)>& load, const std::function<std::string(int)>& torque,
                           const std::string& head = "\"kp\": 32, \"motor\": \"mx106\"") {
  std::string entries;
  for (int i = 0; i < 200; ++i) {
    const double t = 0.0125 * i;
    entries +=
        (i == 0 ? "" : ",") + std::string{"{\"timestamp\": "} + std::to_string(t) +
        ", \"goal_position\": " + std::to_string(0.5 * std::sin(3 * t)) +
        ", \"position\": " + std::to_string(0.5 * std::sin(3 * (t - 0.03))) + ", \"torque_enable\": true" +
        ", \"load\": " + load(i) + ", \"torque\": " + torque(i) +
        ", \"input_volts\": 12.1, \"current\": 0.5, \"speed\": " + std::to_string(1.5 * std::cos(3 * (t - 0.03))) + "}";
  }
  return "{\"mass\": 0.5, \"arm_mass\": 0.1, \"length\": 0.15, \"vin\": 12, \"trajectory\": \"sine\", " + head +
         ", \"entries\": [" + entries + "]}";
}

}  // namespace darwinop::gap
