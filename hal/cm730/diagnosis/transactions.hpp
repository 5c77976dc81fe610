// Single pings, reads and writes with retries, for start-up and tools. The loop never uses them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::cm730 {

struct Patience {
  int tries = 3;
  /// Time-out of a reply beyond its transmission time; covers an FTDI chip with a latency timer of 16 ms.
  Nanos margin{40'000'000};
};

struct Answer {
  LineStatus status = LineStatus::kTimeout;
  std::uint8_t error_bits = 0;
  int tries = 0;         // 1: the first one was answered
  bool garbled = false;  // received bytes that are not a valid reply: noise, or two devices with one id
  Nanos took{0};         // from the request to the last byte of the reply, for the answered try
  std::array<std::uint8_t, 128> bytes{};
  std::size_t count = 0;

  [[nodiscard]] bool ok() const { return status == LineStatus::kOk; }
  [[nodiscard]] Bytes data() const { return Bytes{bytes}.first(count); }
};

/// A reply counts only with the requested id and length.
Answer ping(ByteLine& line, std::uint8_t id, const Patience& patience = {});
/// At most 128 registers.
Answer readRegisters(ByteLine& line, std::uint8_t id, std::uint8_t address, std::uint8_t count,
                     const Patience& patience = {});
/// A servo with status return level 0 or 1 executes the write without a reply.
Answer writeRegisters(ByteLine& line, std::uint8_t id, std::uint8_t address, Bytes data, const Patience& patience = {});

/// Waits on the line's clock and discards received bytes. kLost: the line was lost.
LineStatus pass(ByteLine& line, Nanos duration);

/// Devices wait up to 100 ms for the rest of a frame, so a damaged length byte makes them take the next requests for
/// it. After this time they expect a new frame. Source: CM-730 firmware; of the MX-28 unknown.
inline constexpr Nanos kFrameTimeout{110'000'000};

}  // namespace darwinop::cm730
