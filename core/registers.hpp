// Control tables of the CM-730 board and the MX-28 servo: address, width, access, scale, unit, meaning.
// Used by encoder, decoder, virtual board, doctor and docs/registers.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/servo_limits.hpp"
#include "core/units.hpp"

namespace darwinop {

enum class Access : std::uint8_t { kRead, kReadWrite };
enum class Memory : std::uint8_t { kEeprom, kRam };

struct Register {
  std::string_view name;
  std::uint8_t address, bytes;
  Access access;
  Memory memory;
  std::uint16_t reset, low, high;  // value after power-up or factory reset; range accepted by a write
  double zero, scale;              // SI value = (raw - zero) * scale
  std::string_view unit, note;
};

namespace detail {
inline constexpr auto R = Access::kRead;
inline constexpr auto W = Access::kReadWrite;
inline constexpr auto E = Memory::kEeprom;
inline constexpr auto M = Memory::kRam;
// rad/s per count of the gyroscope; registers, virtual board, recordings, monitor, remote control and the API take it
// from here. Source: the CM-730 firmware, count = clamp(512 + raw16 / 64 * 5 / 4, 0, 1023), and the data sheet of its
// sensor, 70 mdeg/s per digit of raw16 in the range of 2000 deg/s: 3.584 deg/s a count, +-1835 deg/s.
// Not measured. The simulator's model has 1600 deg/s over 512 counts (0.0545 rad/s a count, 1.147
// times less), as if 2000 deg/s were 32768 digits, which the data sheet does not say; the vendor's table has 500 deg/s.
// Turn a robot by 360 degrees on a table and integrate gyro.z of the recording: 360 confirms this, 413 the simulator's.
inline constexpr double kGyroScale = 0.070 * 64.0 * 4.0 / 5.0 * kRadPerDegree;
// CM-730 firmware: raw16 / 64 at +-4 g full scale: 128 counts a g. (The user guide says 3 g.)
inline constexpr double kAccelScale = kGravity / 128.0;
}  // namespace detail

inline constexpr std::uint8_t kBoardId = 200;
inline constexpr std::size_t kBoardTableSize = 81;  // addresses 0..80
inline constexpr std::size_t kServoTableSize = 74;  // addresses 0..73

// Source: CM-730 firmware and control table of the vendor's manual.
inline constexpr auto kCm730 = std::to_array<Register>({
    {"model", 0, 2, detail::R, detail::E, 0x7300, 0, 65535, 0, 1, "", "0x7300"},
    {"firmware", 2, 1, detail::R, detail::E, 0x13, 0, 255, 0, 1, "", "0x13 is the newest published"},
    {"id", 3, 1, detail::W, detail::E, 200, 0, 253, 0, 1, "", ""},
    {"baud", 4, 1, detail::W, detail::E, 1, 1, 254, 0, 1, "", "rate = 2000000 / (n + 1)"},
    {"return_delay", 5, 1, detail::W, detail::E, 0, 0, 254, 0, 2e-6, "s", "2 us a count"},
    {"status_level", 16, 1, detail::W, detail::E, 2, 0, 2, 0, 1, "", "0 ping, 1 and read, 2 all"},
    {"dxl_power", 24, 1, detail::W, detail::M, 0, 0, 1, 0, 1, "bool", "0 cuts the supply of every servo"},
    {"led_panel", 25, 1, detail::W, detail::M, 0, 0, 7, 0, 1, "bits", "back LEDs: 1 red, 2 blue, 4 green"},
    {"led_head", 26, 2, detail::W, detail::M, 0x03E0, 0, 0x7FFF, 0, 1, "rgb15", "bits 0-4 red, 5-9 green, 10-14 blue"},
    {"led_eye", 28, 2, detail::W, detail::M, 0x7C00, 0, 0x7FFF, 0, 1, "rgb15", "as led_head"},
    {"buttons", 30, 1, detail::R, detail::M, 0, 0, 3, 0, 1, "bits", "1 MODE, 2 START; RESET resets the board"},
    {"gyro_z", 38, 2, detail::R, detail::M, 512, 0, 1023, 512, detail::kGyroScale, "rad/s", "order is Z, Y, X"},
    {"gyro_y", 40, 2, detail::R, detail::M, 512, 0, 1023, 512, detail::kGyroScale, "rad/s", ""},
    {"gyro_x", 42, 2, detail::R, detail::M, 512, 0, 1023, 512, detail::kGyroScale, "rad/s", ""},
    {"accel_x", 44, 2, detail::R, detail::M, 512, 0, 1023, 512, detail::kAccelScale, "m/s2", ""},
    {"accel_y", 46, 2, detail::R, detail::M, 512, 0, 1023, 512, detail::kAccelScale, "m/s2", ""},
    {"accel_z", 48, 2, detail::R, detail::M, 640, 0, 1023, 512, detail::kAccelScale, "m/s2", "upright 640"},
    {"voltage", 50, 1, detail::R, detail::M, 118, 0, 255, 0, 0.1, "V", ""},
    {"mic_left", 51, 2, detail::R, detail::M, 512, 0, 1023, 0, 1, "count", "ADC1"},
    {"adc2", 53, 2, detail::R, detail::M, 0, 0, 1023, 0, 1, "count", ""},
    {"mic_right", 67, 2, detail::R, detail::M, 512, 0, 1023, 0, 1, "count", "ADC9; outside the cycle's window"},
});

// Source: vendor's MX-28 manual, protocol 1.0.
inline constexpr auto kMx28 = std::to_array<Register>({
    {"model", 0, 2, detail::R, detail::E, 29, 0, 65535, 0, 1, "", "29 is MX-28"},
    {"firmware", 2, 1, detail::R, detail::E, 36, 0, 255, 0, 1, "", "27 and newer: 4096 steps and PID"},
    {"id", 3, 1, detail::W, detail::E, 1, 0, 253, 0, 1, "", ""},
    {"baud", 4, 1, detail::W, detail::E, 34, 0, 254, 0, 1, "", "rate = 2000000 / (n + 1); factory 57142"},
    {"return_delay", 5, 1, detail::W, detail::E, 250, 0, 254, 0, 2e-6, "s", "2 us a count; factory 500 us"},
    {"cw_limit", 6, 2, detail::W, detail::E, 0, 0, 4095, 2048, kRadPerTick, "rad", ""},
    {"ccw_limit", 8, 2, detail::W, detail::E, 4095, 0, 4095, 2048, kRadPerTick, "rad", ""},
    {"temperature_limit", 11, 1, detail::W, detail::E, 80, 0, 99, 0, 1, "deg C", ""},
    {"low_voltage_limit", 12, 1, detail::W, detail::E, 60, 50, 160, 0, 0.1, "V", ""},
    {"high_voltage_limit", 13, 1, detail::W, detail::E, 160, 50, 160, 0, 0.1, "V", ""},
    {"max_torque", 14, 2, detail::W, detail::E, 1023, 0, 1023, 0, kMaxTorqueNm / kTorqueMax, "N m",
     "copied to 34 at power-up"},
    {"status_level", 16, 1, detail::W, detail::E, 2, 0, 2, 0, 1, "", "0 ping, 1 and read, 2 all"},
    {"alarm_led", 17, 1, detail::W, detail::E, 36, 0, 127, 0, 1, "bits", "error bits that blink the LED"},
    {"shutdown", 18, 1, detail::W, detail::E, 36, 0, 127, 0, 1, "bits",
     "error bits that cut torque; a setting, no alarm"},
    {"multi_turn_offset", 20, 2, detail::W, detail::E, 0, 0, 65535, 0, 1, "", "not used"},
    {"resolution_divider", 22, 1, detail::W, detail::E, 1, 1, 4, 0, 1, "", "not used"},
    {"torque_enable", 24, 1, detail::W, detail::M, 0, 0, 1, 0, 1, "bool", "a goal write sets it by itself"},
    {"led", 25, 1, detail::W, detail::M, 0, 0, 1, 0, 1, "bool", ""},
    {"d_gain", 26, 1, detail::W, detail::M, 0, 0, 254, 0, 4.0 / 1000, "", "Kd = D * 4 / 1000"},
    {"i_gain", 27, 1, detail::W, detail::M, 0, 0, 254, 0, 1000.0 / 2048, "", "Ki = I * 1000 / 2048"},
    {"p_gain", 28, 1, detail::W, detail::M, 32, 0, 254, 0, kGainPerCount, "", "Kp = P / 8"},
    {"reserved29", 29, 1, detail::W, detail::M, 0, 0, 255, 0, 1, "", "must be written when a write spans 28..30"},
    {"goal_position", 30, 2, detail::W, detail::M, 2048, 0, 4095, 2048, kRadPerTick, "rad", "power-up: present"},
    {"moving_speed", 32, 2, detail::W, detail::M, 0, 0, 1023, 0, kRadPerSecPerCount, "rad/s", "0: unlimited"},
    {"torque_limit", 34, 2, detail::W, detail::M, 1023, 0, 1023, 0, kMaxTorqueNm / kTorqueMax, "N m",
     "0 after a shutdown"},
    {"present_position", 36, 2, detail::R, detail::M, 2048, 0, 4095, 2048, kRadPerTick, "rad", ""},
    {"present_speed", 38, 2, detail::R, detail::M, 0, 0, 2047, 0, kRadPerSecPerCount, "rad/s", "bit 10: clockwise"},
    {"present_load", 40, 2, detail::R, detail::M, 0, 0, 2047, 0, 1.0 / 1023, "of max torque", "bit 10: clockwise"},
    {"present_voltage", 42, 1, detail::R, detail::M, 118, 0, 255, 0, 0.1, "V", ""},
    {"present_temperature", 43, 1, detail::R, detail::M, 30, 0, 255, 0, 1, "deg C", ""},
    {"registered", 44, 1, detail::R, detail::M, 0, 0, 1, 0, 1, "bool", ""},
    {"moving", 46, 1, detail::R, detail::M, 0, 0, 1, 0, 1, "bool", ""},
    {"lock", 47, 1, detail::W, detail::M, 0, 0, 1, 0, 1, "bool", "1 locks EEPROM until power-off"},
    {"punch", 48, 2, detail::W, detail::M, 0, 0, 1023, 0, 1, "", ""},
    {"goal_acceleration", 73, 1, detail::W, detail::M, 0, 0, 254, 0, 8.583 * kRadPerDegree, "rad/s2",
     "newer firmware only"},
});

// Registers that MX-64 and MX-106 have beside those; the modes in which goals have no effect. Source: vendor's manuals,
// protocol 1.0; not confirmed on hardware.
inline constexpr auto kStrongerMx = std::to_array<Register>({
    {"drive_mode", 10, 1, detail::W, detail::E, 0, 0, 3, 0, 1, "bits", "MX-106: 1 reverse, 2 slave of another servo"},
    {"torque_control", 70, 1, detail::W, detail::M, 0, 0, 1, 0, 1, "bool", "1: a torque (71) is the goal"},
});

/// The row with this name; the name must exist (checked when evaluated at compile time).
template <std::size_t N>
constexpr const Register& find(const std::array<Register, N>& table, std::string_view name) {
  for (const Register& r : table)
    if (r.name == name) return r;
  return table[N];  // not constant: a wrong name does not compile in a constexpr context
}

template <std::size_t N>
constexpr bool tableIsSound(const std::array<Register, N>& table) {
  for (std::size_t i = 0; i + 1 < N; ++i)
    if (table[i].address + table[i].bytes > table[i + 1].address) return false;
  return true;
}
static_assert(tableIsSound(kCm730) && tableIsSound(kMx28) && tableIsSound(kStrongerMx));

/// Addresses by name, for code that reads and writes single registers.
namespace board {
inline constexpr std::uint8_t kFirmware = find(kCm730, "firmware").address;
inline constexpr std::uint8_t kDxlPower = find(kCm730, "dxl_power").address;
inline constexpr std::uint8_t kLedPanel = find(kCm730, "led_panel").address;
}  // namespace board

namespace servo {
inline constexpr std::uint8_t kFirmware = find(kMx28, "firmware").address;
inline constexpr std::uint8_t kId = find(kMx28, "id").address;
inline constexpr std::uint8_t kReturnDelay = find(kMx28, "return_delay").address;
inline constexpr std::uint8_t kStatusLevel = find(kMx28, "status_level").address;
inline constexpr std::uint8_t kTorqueEnable = find(kMx28, "torque_enable").address;
inline constexpr std::uint8_t kPGain = find(kMx28, "p_gain").address;
inline constexpr std::uint8_t kGoalPosition = find(kMx28, "goal_position").address;
inline constexpr std::uint8_t kMovingSpeed = find(kMx28, "moving_speed").address;
inline constexpr std::uint8_t kTorqueLimit = find(kMx28, "torque_limit").address;
inline constexpr std::uint8_t kPresentPosition = find(kMx28, "present_position").address;
inline constexpr std::uint8_t kPresentVoltage = find(kMx28, "present_voltage").address;
inline constexpr std::uint8_t kLock = find(kMx28, "lock").address;
inline constexpr std::uint8_t kPresentTemperature = find(kMx28, "present_temperature").address;
inline constexpr std::uint8_t kDriveMode = find(kStrongerMx, "drive_mode").address;
inline constexpr std::uint8_t kTorqueControl = find(kStrongerMx, "torque_control").address;
}  // namespace servo

}  // namespace darwinop
