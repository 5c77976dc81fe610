// What can be made to go wrong with a virtual robot, when, and for how long.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/joints.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::hil {

enum class FaultKind : std::uint8_t {
  kDead,     // a servo's plug is out
  kErrors,   // a servo's status packets carry error bits
  kHeat,     // a servo's temperature
  kVoltage,  // supply of the whole robot
  kReset,    // the board's RESET button
  kButton,   // MODE or START
  kFallen,   // accelerometer
  kStall,    // the board neither reads nor answers; what was queued is answered afterwards
  kUnplug,   // the port is gone
  kDrop,     // from here on: bytes between PC and board
  kCorrupt,
  kRepeat,
  kRepeatFrame,
  kDelay,
  kGarbage,
  kRandom,  // faults of the kinds above, drawn from a seed
  kCount
};
inline constexpr std::size_t kFaultKinds = static_cast<std::size_t>(FaultKind::kCount);
using FaultKinds = std::bitset<kFaultKinds>;

/// As a script names them.
inline constexpr std::array<std::string_view, kFaultKinds> kFaultKindNames{
    "dead",   "errors", "heat",    "voltage", "reset",        "button", "fallen",  "stall",
    "unplug", "drop",   "corrupt", "repeat",  "repeat-frame", "delay",  "garbage", "random"};

constexpr bool isWireFault(FaultKind kind) {
  return kind >= FaultKind::kDrop && kind <= FaultKind::kGarbage;
}

/// Which way the bytes go that a wire fault spoils.
enum class Way : std::uint8_t { kReplies = 1, kRequests = 2, kBoth = 3 };

enum class Fall : std::uint8_t { kFront, kBack, kLeft, kRight };

struct Fault {
  static constexpr Nanos kForEver = Nanos::max();

  Nanos at{0};
  FaultKind kind = FaultKind::kReset;
  Nanos lasts = kForEver;       // a wire fault with 0 spoils the next frame and is over
  std::bitset<kJoints> joints;  // dead, errors, heat
  double amount = 0;            // deg C, V, bytes of a frame, ms of delay, or random faults per second
  std::uint8_t bits = 0;        // error bits, or buttons
  Fall fall = Fall::kFront;
  Nanos over{0};  // heat, voltage: reached in a straight line over this time
  Way way = Way::kReplies;
  double chance = 1;                 // that a frame is spoiled
  FaultKinds kinds = ~FaultKinds{};  // random: what may be drawn

  [[nodiscard]] constexpr Nanos end() const { return lasts == kForEver ? kForEver : at + lasts; }
};

}  // namespace darwinop::hil
