// Thread that reports faults while an embedded loop runs.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "runtime/exchange.hpp"

namespace darwinop::runtime {

/// Reads the newest sensors ten times a second and writes to stderr. Independent of the loop.
class FaultWatch {
 public:
  /// `trunk_is_held`: as FaultAnnouncer has it.
  FaultWatch(const Latest<Sensors>& sensors, bool trunk_is_held);
  /// Reads once more, so that faults of a short run are reported.
  ~FaultWatch();
  FaultWatch(const FaultWatch&) = delete;
  FaultWatch& operator=(const FaultWatch&) = delete;

 private:
  void run();

  const Latest<Sensors>& sensors_;
  bool trunk_is_held_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace darwinop::runtime
