// Constants of the MX-28 servo and its supply, with unit and source. Registers: core/registers.hpp.
#pragma once

#include "core/units.hpp"

namespace darwinop {

// Source: MX-28 control table. 4096 steps a turn, 2048 is the middle of the range.
inline constexpr int kTickCentre = 2048;
inline constexpr int kTickMax = 4095;
inline constexpr double kRadPerTick = 2.0 * kPi / 4096.0;  // 1.533981 mrad

// Source: MX-28 control table, moving speed and present speed: 0.114 rpm a count, 1023 counts.
inline constexpr double kRpmPerCount = 0.114;
inline constexpr double kRadPerSecPerCount = kRpmPerCount * kPi / 30.0;  // 0.0119381 rad/s
inline constexpr int kSpeedMax = 1023;

// Source: MX-28 data sheet at 12 V. Stall torque is a torque limit of 1023.
inline constexpr double kNominalSupply = 12.0;                     // V
inline constexpr double kMaxTorqueNm = 2.5;                        // N m, stall
inline constexpr double kStallCurrent = 1.4;                       // A
inline constexpr double kNoLoadRpm = 55;                           // rpm
inline constexpr int kTorqueMax = 1023;                            // counts
inline constexpr double kLeastTorque = kMaxTorqueNm / kTorqueMax;  // N m, one count: 0 would switch the servo off

// Four speeds in rad/s, each with its own meaning:
// - no-load speed at 12 V by the data sheet; under the robot's weight about half of it;
inline constexpr double kNoLoadSpeed = kNoLoadRpm * 2 * kPi / 60;  // 5.760
// - highest speed limit, full scale of the register;
inline constexpr double kRegisterSpeed = kSpeedMax * kRadPerSecPerCount;  // 12.2127
// - the same rounded down, as used in settings and experiment files; and one count, rounded down;
inline constexpr double kFullSpeed = 12.21, kLeastSpeed = 0.0119;
// - maxVelocity of the simulator's model: reported by the Webots API, and the rate limit of goals.
inline constexpr double kMaxVelocity = 12.26;
// Start, kneeling, lead-in of motions: 11.4 rpm, slow enough for a person to intervene. Setting gentle_speed.
inline constexpr double kGentleSpeed = 1.194;  // rad/s

// Source: MX-28 control table: Kp = P / 8, P 0..254.
inline constexpr double kGainPerCount = 1 / 8.0;
inline constexpr double kMaxPGain = 254 * kGainPerCount;  // 31.75
inline constexpr double kDefaultPGain = 4;                // register 32, factory setting
// Position error at Kp 1 with full motor output, rad. Source: MX-28 manual, output 0..1023 over ticks. The twin uses
// half of it, as measured on test benches of this servo family (duty_per_kp_per_rad, twin/servo/parameters.hpp).
inline constexpr double kFullDriveError = 1023 * kRadPerTick;

// deg C. Factory limit: register 11. The others are chosen below it, with margin for a poll once a second.
inline constexpr double kServoShutdownC = 80, kServoOverheatC = 75, kServoHotC = 65;
inline constexpr double kHeatHysteresis = 5;

// V. Servo: factory limits, registers 12 and 13. Battery: 3 LiPo cells at 3.67 V and 3.33 V; lower voltages damage
// them.
inline constexpr double kServoSupplyLow = 6, kServoSupplyHigh = 16;
inline constexpr double kBatteryLowV = 11.0, kBatteryEmptyV = 10.0;
inline constexpr double kBatteryHysteresis = 0.3;  // about the supply drop while walking

}  // namespace darwinop
