// What the loop counts about itself in every cycle, and copies of it that can be subtracted.
#pragma once

#include <atomic>
#include <cstdint>

#include "core/sensors.hpp"
#include "runtime/histogram.hpp"

namespace darwinop::runtime {

/// Figures over a stretch of time: since the loop began, or between two copies.
struct StatsView {
  std::uint32_t cycles = 0;
  std::uint32_t overruns = 0;    // cycles that ended after the next release
  std::uint32_t skipped = 0;     // releases given up because a cycle was still running
  std::uint32_t retries = 0;     // times a silent device was asked again
  std::uint32_t incomplete = 0;  // BulkReads answered in part or not at all
  std::uint32_t late_replies = 0;
  std::uint32_t reconnects = 0;
  HistogramView wake;   // from release to begin of the cycle, us
  HistogramView bus;    // from the first byte written to the last one decoded, us
  HistogramView wire;   // the same bytes at the baud rate, us
  HistogramView slack;  // from the end of a cycle to the next release, us; overruns count as 0

  [[nodiscard]] StatsView since(const StatsView& before) const;
};

/// Lies in shared memory. Written by the loop's thread alone, 32-bit words, relaxed: a reader may be one cycle off.
class LoopStats {
 public:
  enum class Timed : bool { kNo, kYes };  // kNo: time is simulated, so that latency and bus time say nothing

  /// After a cycle. `skipped`: releases given up so far.
  void account(const Sensors& sensors, std::uint32_t skipped, Timed timed) noexcept;

  [[nodiscard]] std::uint32_t cycles() const noexcept { return cycles_.load(std::memory_order_relaxed); }
  void copyTo(StatsView& view) const noexcept;

 private:
  std::atomic<std::uint32_t> cycles_{0}, overruns_{0}, skipped_{0}, retries_{0}, incomplete_{0}, late_replies_{0},
      reconnects_{0};
  Histogram wake_, bus_, wire_, slack_;
};

}  // namespace darwinop::runtime
