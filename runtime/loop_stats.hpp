// Timing and link statistics of the loop, updated in every cycle; copies can be subtracted.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/sensors.hpp"
#include "runtime/histogram.hpp"

namespace darwinop::runtime {

/// Statistics since the loop started, or between two copies.
struct StatsView {
  std::uint32_t cycles = 0;
  std::uint32_t overruns = 0;    // cycles that ended after the next release
  std::uint32_t skipped = 0;     // releases skipped because a cycle was still running
  std::uint32_t retries = 0;     // repeated requests to a device that did not reply
  std::uint32_t incomplete = 0;  // BulkReads with missing replies
  std::uint32_t late_replies = 0;
  std::uint32_t reconnects = 0;
  HistogramView wake;   // from release to start of the cycle, us
  HistogramView bus;    // from the first byte written to the last byte decoded, us
  HistogramView wire;   // transmission time of these bytes at the baud rate, us
  HistogramView slack;  // from the end of a cycle to the next release, us; overruns count as 0

  [[nodiscard]] StatsView since(const StatsView& before) const;
};

/// Usable in shared memory. Written by the loop's thread only, as relaxed 32-bit words: values that a reader gets may
/// differ by one cycle.
class LoopStats {
 public:
  enum class Timed : bool { kNo, kYes };  // kNo: simulated time, where latency and bus time are meaningless

  /// Call after each cycle. `skipped`: releases skipped so far.
  void account(const Sensors& sensors, std::uint32_t skipped, Timed timed) noexcept;

  [[nodiscard]] std::uint32_t cycles() const noexcept { return cycles_.load(std::memory_order_relaxed); }
  void copyTo(StatsView& view) const noexcept;

 private:
  std::atomic<std::uint32_t> cycles_{0}, overruns_{0}, skipped_{0}, retries_{0}, incomplete_{0}, late_replies_{0},
      reconnects_{0};
  Histogram wake_, bus_, wire_, slack_;
};

}  // namespace darwinop::runtime
