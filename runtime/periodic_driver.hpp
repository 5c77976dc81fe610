// Runs the loop in its own SCHED_FIFO thread, with absolute deadlines and locked memory.
#pragma once

#include <atomic>
#include <string>
#include <thread>

#include "runtime/clock.hpp"
#include "runtime/loop.hpp"

namespace darwinop::runtime {

/// What to do when the kernel refuses real-time priority or locked memory.
enum class RealTime {
  kRequired,   // throw an error with a remedy
  kIfAllowed,  // one warning; run without it
};

/// $DARWINOP_REALTIME: "required" or "if-allowed" (default). Throws std::runtime_error for other values.
RealTime realTimeFromEnvironment();
RealTime realTimeFromText(const std::string& text);

struct RealTimeConfig {
  RealTime demand = RealTime::kIfAllowed;
  int priority = 80;  // 1..99; above interrupt threads (50) and below the kernel's own watchdogs (99)
};

class PeriodicDriver {
 public:
  /// Starts the thread; the first cycle is due one period from now. Throws std::runtime_error if real time is required
  /// and refused.
  PeriodicDriver(Loop& loop, Clock& clock, Nanos period, const RealTimeConfig& config);
  /// Finishes the current cycle and joins the thread.
  ~PeriodicDriver();
  PeriodicDriver(const PeriodicDriver&) = delete;
  PeriodicDriver& operator=(const PeriodicDriver&) = delete;

  /// Real-time settings that the kernel refused, with a remedy; empty: none.
  [[nodiscard]] const std::string& warning() const { return warning_; }

 private:
  enum class Start { kPending, kGo, kAbandon };
  void run(int priority) noexcept;

  Loop& loop_;
  Clock& clock_;
  Nanos period_;
  std::string warning_;
  std::atomic<int> refused_{-1};  // -1: not known yet; else bit 0: priority, bit 1: locked memory
  std::atomic<Start> start_{Start::kPending};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace darwinop::runtime
