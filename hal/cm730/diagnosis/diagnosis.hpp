// Derives findings and remedies from the measurements of a probe.
#pragma once

#include <cstdint>
#include <string>

#include "hal/cm730/diagnosis/finding.hpp"
#include "hal/cm730/diagnosis/robot_facts.hpp"

namespace darwinop::cm730 {

/// Since this version: 4096 steps per turn and PID gains; older firmware has 1024 and other registers. Source: MX-28
/// manual.
inline constexpr std::uint8_t kOldestFirmware = 27;
/// Largest accepted return delay: 20 servos x 50 us cost 1 ms per cycle.
inline constexpr std::uint8_t kMostReturnDelay = 25;  // counts of 2 us
/// A short read takes 0.16 ms on the wire and 1 to 2 ms through USB; from here on the FTDI timer is the cause.
inline constexpr Nanos kLatencySignature{8'000'000};
/// The timer delays all reads alike, so the shortest takes this long too. A busy computer or USB hub delays some.
inline constexpr Nanos kTimerDelay{7'000'000};
/// Remedy for delays that are not the timer's.
inline constexpr const char* kDelayRemedy =
    "end other programs on the robot's computer and connect the board without a hub";
/// Accepted loss rate. Others measure 0.2 to 0.4 %; a single loss is normal.
inline constexpr double kLossAlarm = 0.01;

Findings diagnose(const RobotFacts& facts);

/// Whether even the shortest read has the delay of an FTDI latency timer.
inline bool isTimer(const RoundTrip& measured) {
  return measured.shortest >= kTimerDelay;
}

/// An MX-28 or a permitted model, with the registers that this project knows. Nothing is written to any other servo.
bool isSupported(const ServoFacts& servo, const Permitted& permitted);
/// A board of kBoardModels, or the one that robot.ini permits. Nothing is written to any other board or to its servos.
bool isSupported(const RobotFacts& facts);

/// "CM-730", or the model number of a board that has no row.
std::string boardName(const BoardFacts& board);

}  // namespace darwinop::cm730
