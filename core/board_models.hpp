// Boards between computer and servos, with their model numbers.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/registers.hpp"

namespace darwinop {

struct BoardModel {
  std::uint16_t number;  // register 0
  std::string_view name, robot;
  std::string_view registers, power, absent;  // for docs/registers.md
  std::string_view unconfirmed;               // facts not confirmed on hardware; empty: none
};

// Source: the vendor's framework, which drives both boards with the same class. A board with another number needs
// `board_model` in robot.ini.
inline constexpr auto kBoardModels = std::to_array<BoardModel>({
    {find(kCm730, "model").reset, "CM-730", "DARwIn-OP", "[CM-730](#cm-730-id-200)", "`dxl_power`", "none", ""},
    {0x7400, "CM-740", "ROBOTIS OP2", "as the CM-730", "`dxl_power`", "none",
     "model number, registers, gyroscope and accelerometer scale"},
});

/// Servos on a USB2Dynamixel or U2D2; driven with `board = none` in robot.ini only. Nothing answers for the robot as a
/// whole and no button releases it.
inline constexpr BoardModel kNoBoard{
    0,      "none",          "servos on a USB2Dynamixel or U2D2",
    "none", "none: unknown", "inertial sensor, LEDs, buttons, microphones, supply voltage",
    "all"};

/// The row of this model number; null: there is none.
constexpr const BoardModel* findBoardModel(std::uint16_t number) {
  for (const BoardModel& model : kBoardModels)
    if (model.number == number) return &model;
  return nullptr;
}

}  // namespace darwinop
