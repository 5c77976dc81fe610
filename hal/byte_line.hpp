// Byte transport to a CM-730: serial port, pty, or memory. It provides its own clock, so that deadlines work in real
// and in simulated time.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace darwinop {

using Nanos = std::chrono::nanoseconds;

enum class LineStatus : std::uint8_t {
  kOk,
  kTimeout,  // the deadline passed
  kLost,     // unplugged or closed; reconnects automatically
};

/// Called by the loop's thread only. No function throws, allocates, locks or logs.
class ByteLine {
 public:
  virtual ~ByteLine() = default;
  /// Monotonic clock of this line.
  [[nodiscard]] virtual Nanos now() noexcept = 0;
  /// Queues all bytes; does not wait for transmission. Returns kLost or kTimeout if not all fit.
  virtual LineStatus write(std::span<const std::uint8_t> bytes) noexcept = 0;
  /// Waits for bytes until `deadline`. kOk: at least one byte in `into`.
  virtual LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept = 0;
  /// Discards received bytes that were not read.
  virtual void discardInput() noexcept = 0;
  /// Number of reconnects.
  [[nodiscard]] virtual std::uint32_t reconnects() const noexcept = 0;
};

}  // namespace darwinop
