// Parses the byte stream from the PC into instruction frames as a device does: by length, then checksum.
#pragma once

#include <array>
#include <cstdint>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::hil {

/// Unlike core's FrameReader, a device does not resynchronize inside a broken frame: it consumes as many bytes as the
/// length field says. Implemented independently, so that an error in one of them is detected.
class InstructionParser {
 public:
  enum class Result : std::uint8_t { kMore, kFrame, kBadChecksum };

  /// Takes one byte received at `when`. After kFrame and kBadChecksum the frame is readable until the next byte.
  Result take(std::uint8_t byte, Nanos when) noexcept {
    // CM-730 firmware: 100 ms timeout between two bytes of a frame.
    if (used_ >= 4 + length() || (used_ > 0 && when - last_ > kByteTimeout)) used_ = 0;
    last_ = when;
    if (used_ < 2) {
      used_ = byte == 0xFF ? used_ + 1 : 0;
      return Result::kMore;
    }
    if (used_ == 2 && byte == 0xFF) return Result::kMore;  // another FF: the id follows
    frame_[used_++] = byte;
    if (used_ == 4 && byte < 2) used_ = 0;  // invalid length
    if (used_ < 4 || used_ < 4 + length()) return Result::kMore;
    unsigned sum = 0;
    for (std::size_t i = 2; i + 1 < used_; ++i) sum += frame_[i];
    return ((sum + frame_[used_ - 1]) & 0xFF) == 0xFF ? Result::kFrame : Result::kBadChecksum;
  }

  void clear() noexcept { used_ = 0; }
  /// Minimum number of further bytes until a frame is complete.
  [[nodiscard]] std::size_t missing() const noexcept {
    if (used_ < 4) return kFrameOverhead - used_;
    return used_ < 4 + length() ? 4 + length() - used_ : kFrameOverhead;
  }
  [[nodiscard]] std::uint8_t id() const noexcept { return frame_[2]; }
  [[nodiscard]] std::uint8_t instruction() const noexcept { return frame_[4]; }
  [[nodiscard]] Bytes params() const noexcept { return Bytes{frame_}.subspan(5, length() - 2); }

 private:
  static constexpr Nanos kByteTimeout = std::chrono::milliseconds{100};
  /// Large until the length byte has arrived.
  [[nodiscard]] std::size_t length() const noexcept { return used_ < 4 ? kMaxFrame : frame_[3]; }

  std::array<std::uint8_t, kMaxFrame> frame_{0xFF, 0xFF};
  std::size_t used_ = 0;
  Nanos last_{0};
};

}  // namespace darwinop::hil
