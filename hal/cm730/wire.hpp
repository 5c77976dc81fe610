// Transmission times on the bus, and the registers that a cycle reads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/packet.hpp"
#include "core/registers.hpp"
#include "hal/byte_line.hpp"

namespace darwinop::cm730 {

/// 1 Mbaud, one start and one stop bit: 10 us per byte.
inline constexpr Nanos kByteTime{10'000};
constexpr Nanos wireTime(std::size_t bytes) {
  return kByteTime * static_cast<std::int64_t>(bytes);
}

/// `count` bytes of registers from `address` on.
struct RegisterWindow {
  std::uint8_t address, count;
  [[nodiscard]] constexpr std::size_t frameBytes() const { return count + kFrameOverhead; }
};

// Board: power, LEDs, buttons, gyro, accelerometer, voltage, left microphone.
inline constexpr RegisterWindow kBoardWindow{24, 30};  // 24..53

// Servos: position, speed, load in every cycle. The torque limit (34, 35) is read by the poll: the error byte of every
// reply reports a shutdown sooner, and 20 x 2 bytes would cost 0.4 ms per cycle.
inline constexpr RegisterWindow kServoWindow{36, 6};  // 36..41

// Round-robin poll of one servo per cycle: torque enable, gains, goal, limits, motion, voltage, temperature. 14 bytes
// more: 0.14 ms; a round of twenty servos takes 0.32 s at 16 ms.
inline constexpr RegisterWindow kServoPoll{24, 20};  // 24..43

/// Without a board the servo read first carries the request tag (request_tag.hpp): its poll begins at an earlier
/// register, so that it has `bytes`. Registers 0..43 are all described in the manual.
constexpr RegisterWindow taggedPoll(std::uint8_t bytes) {
  return {static_cast<std::uint8_t>(kServoPoll.address + kServoPoll.count - bytes), bytes};
}

/// Window to read from a servo; index: whether it is polled.
inline constexpr std::array<RegisterWindow, 2> kServoWindows{kServoWindow, kServoPoll};

static_assert(kServoWindow.address == servo::kPresentPosition);
static_assert(kServoPoll.address + kServoPoll.count == servo::kPresentTemperature + 1);

}  // namespace darwinop::cm730
