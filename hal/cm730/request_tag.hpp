// Distinguishes the reply to this request from late replies to earlier ones. Protocol 1.0 has no sequence number, so
// the length of the block that is read first serves as one: it changes with every request. The board is read first;
// without a board a servo, with a length that no other servo is read with.
#pragma once

#include <cstdint>

#include "core/registers.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {

class RequestTag {
 public:
  static constexpr std::uint8_t kMostBytes = kBoardTableSize - kBoardWindow.address;  // 57

  static constexpr std::uint8_t kLeastServoBytes = kServoPoll.count + 1;
  static constexpr std::uint8_t kMostServoBytes = kServoPoll.address + kServoPoll.count;  // 44

  /// `fixed`: the board supports one length only; late replies are not detected.
  explicit RequestTag(bool fixed = false, bool board = true)
      : fixed_{fixed},
        least_{board ? kBoardWindow.count : kLeastServoBytes},
        all_tags_{board ? kMostBytes - kBoardWindow.count + 1 : kMostServoBytes - kLeastServoBytes + 1} {}

  /// Number of bytes to request from the board, from address 24 on; or of taggedPoll().
  [[nodiscard]] std::uint8_t bytes() const noexcept { return static_cast<std::uint8_t>(least_ + (fixed_ ? 0 : tag_)); }

  /// Call after every exchange. `doubtful`: the reply read first is missing and may still arrive.
  void note(bool doubtful) noexcept {
    if (doubtful)
      wary_ = kWaryCycles;
    else if (wary_ > 0)
      --wary_;
    tag_ = (tag_ + 1) % (wary_ > 0 ? all_tags_ : kCalmTags);
  }

 private:
  static constexpr int kCalmTags = 4;  // costs 15 us per cycle on average; no reply is three cycles late undetected
  static constexpr int kWaryCycles = 64;
  bool fixed_;
  std::uint8_t least_;
  int all_tags_;  // 28; of a servo 24
  int tag_ = 0, wary_ = 0;
};

}  // namespace darwinop::cm730
