// Robot link to the loop of a daemon, through shared memory.
#pragma once

#include "runtime/clock.hpp"
#include "runtime/exchange_link.hpp"
#include "runtime/file_lock.hpp"
#include "runtime/names.hpp"

namespace darwinop::runtime {

/// Pid of the daemon that hosts the loop; 0: none runs; -1: probably one of another user.
pid_t daemonPid(const RuntimeFiles& files);

class DaemonLink final : public ExchangeLink {
 public:
  /// Takes the driving lease. Throws std::runtime_error with a remedy if no daemon runs, if it has another version, or
  /// if another controller drives.
  explicit DaemonLink(const RuntimeFiles& files = RuntimeFiles{});
  /// Ends the session and releases the lease; the daemon brings the robot to rest.
  ~DaemonLink() override;

  [[nodiscard]] const RuntimeFiles& files() const { return files_; }

  [[nodiscard]] Nanos now() const override { return clock_.now(); }
  [[nodiscard]] bool realTime() const override { return true; }
  [[nodiscard]] bool bringsToRest() const override { return false; }
  void leaveHolding() override { ends_session_ = false; }
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;

 private:
  [[nodiscard]] bool daemonAnswers(Nanos asleep_since);
  [[nodiscard]] bool runtimeEnds();

  RuntimeFiles files_;
  MonotonicClock clock_;
  FileLock lease_;
  bool ends_session_ = true, end_seen_ = false;
};

}  // namespace darwinop::runtime
