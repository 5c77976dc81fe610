// Turns what a probe has measured into findings, each with the sentence that mends it.
#pragma once

#include <cstdint>

#include "hal/cm730/finding.hpp"
#include "hal/cm730/robot_facts.hpp"

namespace darwinop::cm730 {

/// Newer firmware has 4096 steps a turn and PID gains; older has 1024 steps and other registers. Source: MX-28 manual.
inline constexpr std::uint8_t kOldestFirmware = 27;
/// Greatest return delay that is left alone: 20 servos x 50 us cost a cycle 1 ms.
inline constexpr std::uint8_t kMostReturnDelay = 25;  // counts of 2 us
/// A short read takes 0.16 ms on the wire and 1 to 2 ms through USB; from here on the chip's timer is to blame.
inline constexpr Nanos kLatencySignature{8'000'000};
/// Single losses are normal (0.2 to 0.4 % is what others measure); alarm is on the rate, never on one miss.
inline constexpr double kLossAlarm = 0.01;
/// Of a period, for waking up late and computing.
inline constexpr Nanos kHeadroom{1'000'000};

Findings diagnose(const RobotFacts& facts);

/// Time of a full cycle with twenty servos: bytes, return delays, and what the round trip adds to them.
Nanos cycleTime(const RobotFacts& facts);
/// Whether the period has room for it. Goals alone, the write of most cycles, must leave kHeadroom; the full write, of
/// one cycle in 16 and of those that change a speed, torque limit or gain, must fit. What USB adds must stay within the
/// margin that the bus waits for a reply.
bool cycleFits(const RobotFacts& facts);

}  // namespace darwinop::cm730
