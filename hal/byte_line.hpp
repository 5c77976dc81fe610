// A line that carries bytes to a CM-730 and back: serial port, pty, or memory. It brings its own clock, so that
// deadlines mean the same in real and in simulated time.
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
  kLost,     // unplugged or closed; the line is trying to come back by itself
};

/// Used by the loop's thread only. No function throws, allocates, locks or logs.
class ByteLine {
 public:
  virtual ~ByteLine() = default;
  /// Monotonic time of this line.
  [[nodiscard]] virtual Nanos now() noexcept = 0;
  /// Hands all bytes over; does not wait until they are on the wire. A line that cannot take them all is kLost
  /// or kTimeout.
  virtual LineStatus write(std::span<const std::uint8_t> bytes) noexcept = 0;
  /// Waits for bytes until `deadline` at most; kOk with at least one byte in `into`, or why not.
  virtual LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept = 0;
  /// Throws away what has come and was not read.
  virtual void discardInput() noexcept = 0;
  /// Counts how often the line came back after it was lost.
  [[nodiscard]] virtual std::uint32_t reconnects() const noexcept = 0;
};

}  // namespace darwinop
