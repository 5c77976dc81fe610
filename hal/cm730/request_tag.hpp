// Distinguishes the reply to this request from late replies to earlier ones. Protocol 1.0 has no sequence number, so
// the length of the board's block serves as one: it changes with every request.
#pragma once

#include <cstdint>

#include "core/registers.hpp"
#include "hal/cm730/wire.hpp"

namespace darwinop::cm730 {

class RequestTag {
 public:
  static constexpr std::uint8_t kMostBytes = kBoardTableSize - kBoardWindow.address;  // 57

  /// `fixed`: the board supports one length only; late replies are not detected.
  explicit RequestTag(bool fixed = false) : fixed_{fixed} {}

  /// Number of bytes to request from the board, from address 24 on.
  [[nodiscard]] std::uint8_t boardBytes() const noexcept {
    return static_cast<std::uint8_t>(kBoardWindow.count + (fixed_ ? 0 : tag_));
  }

  /// Call after every exchange. `doubtful`: the board's reply is missing and may still arrive.
  void note(bool doubtful) noexcept {
    if (doubtful)
      wary_ = kWaryCycles;
    else if (wary_ > 0)
      --wary_;
    tag_ = (tag_ + 1) % (wary_ > 0 ? kAllTags : kCalmTags);
  }

 private:
  static constexpr int kAllTags = kMostBytes - kBoardWindow.count + 1;  // 28
  static constexpr int kCalmTags = 4;  // costs 15 us per cycle on average; no reply is three cycles late undetected
  static constexpr int kWaryCycles = 64;
  bool fixed_;
  int tag_ = 0, wary_ = 0;
};

}  // namespace darwinop::cm730
