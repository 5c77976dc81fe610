// Runs the loop in a thread of its own, SCHED_FIFO, on absolute deadlines, with its memory locked.
#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "runtime/clock.hpp"
#include "runtime/loop.hpp"

namespace darwinop::runtime {

/// What to do when the kernel refuses real-time priority or locked memory.
enum class RealTime {
  kRequired,   // an error that says what to do
  kIfAllowed,  // one warning, then as well as it goes
};

/// $DARWINOP_REALTIME: "required" or "if-allowed" (when unset). Throws std::runtime_error for anything else.
RealTime realTimeFromEnvironment();
RealTime realTimeFromText(const std::string& text);

struct RealTimeConfig {
  RealTime demand = RealTime::kIfAllowed;
  int priority = 80;  // 1..99; above interrupt threads (50) and below the kernel's own watchdogs (99)
};

class PeriodicDriver {
 public:
  /// Starts the thread; the first cycle is due one period from now. Throws when real time is required and refused.
  PeriodicDriver(Loop& loop, Clock& clock, Nanos period, const RealTimeConfig& config);
  /// Finishes the cycle that runs and joins the thread.
  ~PeriodicDriver();
  PeriodicDriver(const PeriodicDriver&) = delete;
  PeriodicDriver& operator=(const PeriodicDriver&) = delete;

  /// Refused settings and the remedy; empty: none.
  [[nodiscard]] const std::string& warning() const { return warning_; }

 private:
  enum class Start { kPending, kGo, kAbandon };
  void run(int priority) noexcept;

  Loop& loop_;
  Clock& clock_;
  Nanos period_;
  std::string warning_;
  std::atomic<int> refused_{-1};  // -1: not tried yet; bit 0 priority, bit 1 memory
  std::atomic<Start> start_{Start::kPending};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace darwinop::runtime
