// The MX-28 servo and its supply in numbers: each once, with unit and source. Registers: core/registers.hpp.
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
inline constexpr double kNominalSupply = 12.0;  // V
inline constexpr double kMaxTorqueNm = 2.5;     // N m, stall
inline constexpr double kStallCurrent = 1.4;    // A
inline constexpr double kNoLoadRpm = 55;        // rpm
inline constexpr int kTorqueMax = 1023;         // counts

// Four speeds in rad/s, and why none of them replaces another:
// - what a servo reaches without load at 12 V, by the data sheet; under the robot's weight about half of it;
inline constexpr double kNoLoadSpeed = kNoLoadRpm * 2 * kPi / 60;  // 5.760
// - the highest speed limit that can be written, full scale of the register;
inline constexpr double kRegisterSpeed = kSpeedMax * kRadPerSecPerCount;  // 12.2127
// - the same rounded down, as settings and experiment files write it; and one count, rounded down;
inline constexpr double kFullSpeed = 12.21, kLeastSpeed = 0.0119;
// - maxVelocity of the simulator's model of this robot: what the Webots API reports, and what a goal may move by.
inline constexpr double kMaxVelocity = 12.26;
// Start, kneeling, lead-in of motions: 11.4 rpm, slow enough to step in. config.ini may change it (gentle_speed).
inline constexpr double kGentleSpeed = 1.194;  // rad/s

// Source: MX-28 control table: Kp = P / 8, P 0..254.
inline constexpr double kGainPerCount = 1 / 8.0;
inline constexpr double kMaxPGain = 254 * kGainPerCount;  // 31.75
inline constexpr double kDefaultPGain = 4;                // register 32, factory setting
// rad of error at Kp 1 that drives the motor fully. Source: MX-28 manual, output 0..1023 over ticks. The twin needs
// half of it, as measured on benches of this servo family (duty_per_kp_per_rad, twin/servo/parameters.hpp).
inline constexpr double kFullDriveError = 1023 * kRadPerTick;

// deg C. Factory limit: register 11. The others are ours: below it with room for a poll that comes once a second.
inline constexpr double kServoShutdownC = 80, kServoOverheatC = 75, kServoHotC = 65;
inline constexpr double kHeatHysteresis = 5;

// V. Servo: factory limits, registers 12 and 13. Battery: 3 LiPo cells at 3.67 V and at 3.33 V; less harms them.
inline constexpr double kServoSupplyLow = 6, kServoSupplyHigh = 16;
inline constexpr double kBatteryLowV = 11.0, kBatteryEmptyV = 10.0;
inline constexpr double kBatteryHysteresis = 0.3;  // walking pulls the supply down by about that much

}  // namespace darwinop
