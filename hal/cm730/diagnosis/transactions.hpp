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
  /// How long past its wire time an answer may take; long enough for an FTDI chip that holds bytes back for 16 ms.
  Nanos margin{40'000'000};
};

struct Answer {
  LineStatus status = LineStatus::kTimeout;
  std::uint8_t error_bits = 0;
  int tries = 0;         // 1: answered at once
  bool garbled = false;  // bytes came that were no answer: noise, or two devices with one id
  Nanos took{0};         // from the request to the last byte, of the try that was answered
  std::array<std::uint8_t, 128> bytes{};
  std::size_t count = 0;

  [[nodiscard]] bool ok() const { return status == LineStatus::kOk; }
  [[nodiscard]] Bytes data() const { return Bytes{bytes}.first(count); }
};

/// An answer counts when both its id and its length are the ones asked for.
Answer ping(ByteLine& line, std::uint8_t id, const Patience& patience = {});
/// At most 128 registers.
Answer readRegisters(ByteLine& line, std::uint8_t id, std::uint8_t address, std::uint8_t count,
                     const Patience& patience = {});
/// A servo with status return level 0 or 1 carries the write out and says nothing.
Answer writeRegisters(ByteLine& line, std::uint8_t id, std::uint8_t address, Bytes data, const Patience& patience = {});

/// Lets time pass on the line's own clock; whatever arrives is thrown away. kLost: the line went away.
LineStatus pass(ByteLine& line, Nanos duration);

}  // namespace darwinop::cm730
