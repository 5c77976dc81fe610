// `darwinop runtime`: hosts the loop in its own process, which keeps running when controllers end.
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
#include "runtime/torque_left.hpp"

namespace darwinop::runtime {

/// Exit code of `darwinop runtime`: some joint may be under torque.
inline constexpr int kExitUnderTorque = 4;

/// Lock that permits one daemon per name. Take it before the port is opened. Throws std::runtime_error with the pid of
/// the daemon that runs.
FileLock claimRuntime(const RuntimeFiles& files, gid_t group);

class Daemon {
 public:
  /// Starts the loop and accepts controllers. Throws std::runtime_error with a remedy.
  Daemon(const LoopConfig& config, const RuntimeFiles& files, FileLock claim, gid_t group,
         std::unique_ptr<ServoBus> bus);
  /// Removes the exchange, so that no process attaches to a dead loop.
  ~Daemon();

  /// Returns once `stop` is true, the controller has ended, within 3 s, and safety has brought the robot to rest: the
  /// joints that may be under torque nevertheless, because a servo keeps it or nothing is known of it. If the exchange
  /// is lost, brings the robot to rest and throws std::runtime_error.
  [[nodiscard]] JointSet run(const std::atomic<bool>& stop);

  /// Real-time settings that the kernel refused, with a remedy; empty: none.
  [[nodiscard]] const std::string& warning() const { return driver_.warning(); }

 private:
  void letControllerEnd();
  [[nodiscard]] Sensors sensors() const;

  RuntimeFiles files_;
  FileLock claim_;
  RobotNotes notes_;  // initially those of the previous daemon
  Exchange exchange_;
  Rest rest_;
  MonotonicClock clock_;
  LoopHost host_;
  PeriodicDriver driver_;  // last member: destroyed first
};

}  // namespace darwinop::runtime
