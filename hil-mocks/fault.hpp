// Faults of a virtual robot: kind, start and duration.
#pragma once

#include <array>
#include <bitset>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

#include "core/joints.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::hil {

enum class FaultKind : std::uint8_t {
  kDead,     // a servo is disconnected
  kErrors,   // error bits in a servo's status packets
  kHeat,     // servo temperature
  kVoltage,  // supply voltage of the robot
  kReset,    // the board's RESET button
  kButton,   // MODE or START
  kFallen,   // accelerometer
  kStall,    // the board neither reads nor replies; queued requests are answered afterwards
  kUnplug,   // serial port unplugged
  kJam,      // blocked joint: its servo trips by overload after a time under torque
  kMiss,     // BULK_READs that no device receives
  kBabble,   // unsolicited bytes
  kTwins,    // a second device with a servo's id
  kSag,      // voltage drop proportional to the servos' current
  kNoise,    // on the servos' bus: a servo misses a request, or its answer is damaged, also for those behind it
  kDrop,     // from here on: bytes between PC and board
  kCorrupt,
  kRepeat,
  kRepeatFrame,
  kDelay,
  kGarbage,
  kRandom,  // random faults of the kinds above, from a seed
  kCount
};
inline constexpr std::size_t kFaultKinds = static_cast<std::size_t>(FaultKind::kCount);
using FaultKinds = std::bitset<kFaultKinds>;

/// Names in fault scripts.
inline constexpr std::array<std::string_view, kFaultKinds> kFaultKindNames{
    "dead",   "errors", "heat", "voltage", "reset", "button",  "fallen", "stall",        "unplug", "jam",     "miss",
    "babble", "twins",  "sag",  "noise",   "drop",  "corrupt", "repeat", "repeat-frame", "delay",  "garbage", "random"};

constexpr bool isWireFault(FaultKind kind) {
  return kind >= FaultKind::kDrop && kind <= FaultKind::kGarbage;
}

/// A servo restarts below this voltage (V). Assumption: the MX-28 is specified from 10 V, the real limit is unknown.
inline constexpr double kBrownOutV = 5.5;

constexpr Nanos faultTime(double seconds) {
  return std::chrono::duration_cast<Nanos>(std::chrono::duration<double>(seconds));
}

/// Direction affected by a wire fault.
enum class Way : std::uint8_t { kReplies = 1, kRequests = 2, kBoth = 3 };

enum class Fall : std::uint8_t { kFront, kBack, kLeft, kRight };

struct InjectedFault {
  static constexpr Nanos kForEver = Nanos::max();

  Nanos at{0};
  FaultKind kind = FaultKind::kReset;
  Nanos lasts = kForEver;       // 0 for a wire fault: the next frame only
  std::bitset<kJoints> joints;  // dead, errors, heat, jam, twins, noise
  double amount = 0;            // deg C, V, s, bytes per frame, ms of delay, BULK_READs, or random faults per second
  std::uint8_t bits = 0;        // error bits, or buttons
  Fall fall = Fall::kFront;
  Nanos over{0};  // heat, voltage: duration of the linear ramp
  Way way = Way::kReplies;
  double chance = 1;          // probability per frame; per status for error bits; per request and answer for noise
  std::optional<Nanos> boot;  // dead: boot time afterwards; empty: BoardOptions
  FaultKinds kinds = ~FaultKinds{};  // random: kinds to draw from

  [[nodiscard]] constexpr Nanos end() const { return lasts == kForEver ? kForEver : at + lasts; }
};

}  // namespace darwinop::hil
