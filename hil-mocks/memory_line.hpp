// In-memory byte line with a simulated clock: fast and deterministic.
#pragma once

#include <cstdint>

#include "core/packet.hpp"
#include "hal/byte_line.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace darwinop::hil {

/// Receives the traffic of a line; for tests and recordings.
class WireObserver {
 public:
  virtual ~WireObserver() = default;
  /// A frame sent by the PC, at its send time. Bytes outside frames are not reported.
  virtual void request(const Frame& frame, Nanos at) noexcept = 0;
  /// Bytes read by the PC, after faults; normally one status frame.
  virtual void reply(Bytes bytes, Nanos at) noexcept = 0;
};

struct LineCounters {
  std::uint64_t frames = 0, sync_writes = 0, bulk_reads = 0;
  std::uint64_t bytes_out = 0, bytes_in = 0;
};

/// Owns the clock: writing takes no time, reading advances to the next reply or to the deadline, advanceTo() to any
/// later time.
class MemoryLine : public ByteLine {
 public:
  explicit MemoryLine(VirtualRobot& robot) : robot_{robot} {}

  [[nodiscard]] Nanos now() noexcept override { return now_; }
  LineStatus write(std::span<const std::uint8_t> bytes) noexcept override;
  LineStatus read(std::span<std::uint8_t> into, std::size_t& count, Nanos deadline) noexcept override;
  void discardInput() noexcept override;
  [[nodiscard]] std::uint32_t reconnects() const noexcept override { return robot_.replugs(); }

  /// Advances simulated time; a time in the past is ignored.
  void advanceTo(Nanos when) noexcept;

  [[nodiscard]] VirtualRobot& robot() noexcept { return robot_; }
  [[nodiscard]] const LineCounters& counters() const noexcept { return counters_; }
  /// May be null.
  void observe(WireObserver* observer) noexcept { observer_ = observer; }

 private:
  VirtualRobot& robot_;
  Nanos now_{0};
  FrameReader sent_;
  LineCounters counters_;
  WireObserver* observer_ = nullptr;
};

}  // namespace darwinop::hil
