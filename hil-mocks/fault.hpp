// What can be made to go wrong with a virtual robot, when, and for how long.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <limits>
#include <optional>
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
  kJam,      // a joint is stuck: its servo trips by overload after a while under torque
  kMiss,     // BULK_READs that no device hears
  kBabble,   // bytes that nobody asked for
  kTwins,    // a second device answers to the id of a servo
  kSag,      // the supply falls with what the servos draw
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
    "dead",   "errors", "heat", "voltage", "reset",   "button", "fallen",       "stall", "unplug",  "jam",   "miss",
    "babble", "twins",  "sag",  "drop",    "corrupt", "repeat", "repeat-frame", "delay", "garbage", "random"};

constexpr bool isWireFault(FaultKind kind) {
  return kind >= FaultKind::kDrop && kind <= FaultKind::kGarbage;
}

/// Under this a servo restarts (V). The MX-28 is specified from 10 V on; where it gives up is not: an assumption.
inline constexpr double kBrownOutV = 5.5;

/// Which way the bytes go that a wire fault spoils.
enum class Way : std::uint8_t { kReplies = 1, kRequests = 2, kBoth = 3 };

enum class Fall : std::uint8_t { kFront, kBack, kLeft, kRight };

struct Fault {
  static constexpr Nanos kForEver = Nanos::max();

  Nanos at{0};
  FaultKind kind = FaultKind::kReset;
  Nanos lasts = kForEver;       // a wire fault with 0 spoils the next frame and is over
  std::bitset<kJoints> joints;  // dead, errors, heat, jam, twins
  double amount = 0;            // deg C, V, s, bytes of a frame, ms of delay, BULK_READs, or random faults per second
  std::uint8_t bits = 0;        // error bits, or buttons
  Fall fall = Fall::kFront;
  Nanos over{0};  // heat, voltage: reached in a straight line over this time
  Way way = Way::kReplies;
  double chance = 1;                 // that a frame is spoiled, or that a status carries the error bits
  std::optional<Nanos> boot;         // dead: time to start afterwards; nothing: as the board has it
  FaultKinds kinds = ~FaultKinds{};  // random: what may be drawn

  [[nodiscard]] constexpr Nanos end() const { return lasts == kForEver ? kForEver : at + lasts; }
};

}  // namespace darwinop::hil
