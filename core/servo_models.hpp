// Servo models with their model numbers. A servo is driven only if its model is a row here: the software assumes the
// registers of kMx28 (core/registers.hpp) at the same addresses, 4096 steps a turn and 0.114 rpm a count.
#pragma once

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/registers.hpp"
#include "core/servo_limits.hpp"

namespace darwinop {

enum class ServoUse : std::uint8_t {
  kDriven,
  kIfPermitted,  // same registers and units, but stronger, and not tried on hardware: robot.ini must name it
  kRefused,      // other registers
};

struct ServoModel {
  std::uint16_t number;  // register 0
  std::string_view name;
  ServoUse use;
  std::uint8_t oldest_firmware;      // 0: every version
  double stall_torque, no_load_rpm;  // N m, rpm at 12 V; 1023 counts of load and torque limit are the stall torque
  bool on_robots;                    // upstream's software has driven it
  std::string_view note;
};

// Source: the vendor's manuals of each model. This project has driven no physical robot; the registers and units of the
// MX-28 are those that upstream's software uses on DARwIn-OPs.
inline constexpr auto kServoModels = std::to_array<ServoModel>({
    {29, "MX-28", ServoUse::kDriven, 27, kMaxTorqueNm, kNoLoadRpm, true,
     "also an MX-28 2.0 with firmware of protocol 1.0; firmware before 27 has 1024 steps"},
    {310, "MX-64", ServoUse::kIfPermitted, 0, 6.0, 63, false, ""},
    {320, "MX-106", ServoUse::kIfPermitted, 0, 8.4, 45, false, ""},
    {30, "MX-28(2.0)", ServoUse::kRefused, 0, 2.5, 55, false,
     "other registers, whichever protocol register 13 selects: install firmware of protocol 1.0"},
    {311, "MX-64(2.0)", ServoUse::kRefused, 0, 6.0, 63, false, "as MX-28(2.0)"},
    {321, "MX-106(2.0)", ServoUse::kRefused, 0, 8.4, 45, false, "as MX-28(2.0)"},
});

/// Rows of kServoModels.
using ServoModels = std::bitset<kServoModels.size()>;

/// The row of this model number; null: there is none.
constexpr const ServoModel* findServoModel(std::uint16_t number) {
  for (const ServoModel& model : kServoModels)
    if (model.number == number) return &model;
  return nullptr;
}

/// True: it is driven, given the rows that robot.ini permits.
inline bool isDriven(const ServoModel& model, const ServoModels& permitted) {
  const auto row = static_cast<std::size_t>(&model - kServoModels.data());
  return model.use == ServoUse::kDriven || (model.use == ServoUse::kIfPermitted && permitted[row]);
}

// Weaker servos would get a higher torque limit than they have; the row of the MX-28 is the scale of all others.
static_assert(kServoModels[0].number == find(kMx28, "model").reset && kServoModels[0].stall_torque == kMaxTorqueNm);
static_assert(std::ranges::all_of(kServoModels, [](const ServoModel& m) { return m.stall_torque >= kMaxTorqueNm; }));

}  // namespace darwinop
