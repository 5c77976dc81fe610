// The loop in a process of its own, which outlives its controllers.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <memory>
#include <string>

#include "runtime/clock.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/loop_host.hpp"
#include "runtime/names.hpp"
#include "runtime/rest.hpp"
#include "runtime/robot_notes.hpp"

namespace darwinop::runtime {

/// The right to be the one daemon of that name. Taken before the port is opened. Throws std::runtime_error that
/// names the pid of the one that runs.
FileLock claimRuntime(const RuntimeFiles& files, gid_t group);

class Daemon {
 public:
  /// Starts the loop and lets controllers in. Throws std::runtime_error with what to do.
  Daemon(const LoopConfig& config, const RuntimeFiles& files, FileLock claim, gid_t group,
         std::unique_ptr<ServoBus> bus);
  /// Removes the exchange, so that nobody attaches to a dead loop.
  ~Daemon();

  /// Returns when `stop` became true and safety has brought the robot to rest. Throws std::runtime_error, after the
  /// same, when the exchange was lost.
  void run(const std::atomic<bool>& stop);

  /// Refused real-time settings and the remedy; empty: none.
  [[nodiscard]] const std::string& warning() const { return driver_.warning(); }

 private:
  [[nodiscard]] Sensors sensors() const;

  RuntimeFiles files_;
  FileLock claim_;
  RobotNotes notes_;  // of a daemon before this one
  Exchange exchange_;
  Rest rest_;
  MonotonicClock clock_;
  LoopHost host_;
  PeriodicDriver driver_;  // last: it ends first
};

}  // namespace darwinop::runtime
