// Serves a virtual robot on a pseudo terminal in real time.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "hil-mocks/latency_timer.hpp"
#include "hil-mocks/pty.hpp"
#include "hil-mocks/virtual_robot.hpp"

namespace darwinop::hil {

struct PtyOptions {
  std::string link;        // symbolic link to the port, re-pointed after every replug; empty: none
  Nanos latency_timer{0};  // FTDI's; 16 ms is the default of its driver, 0 is none
  Nanos at_rest = std::chrono::milliseconds{50};  // the body moves at least so often; the less it costs, the longer
};

/// One thread, at SCHED_FIFO 70 where that is allowed. Whole status frames leave at the time at which 1 Mbaud
/// would have delivered their last byte; each is scheduled on the absolute clock, so lateness does not add up.
class PtyHost {
 public:
  /// Starts serving. Throws std::runtime_error if there is no pseudo terminal or the link cannot be made.
  explicit PtyHost(VirtualRobot& robot, const PtyOptions& options = {});
  ~PtyHost();
  PtyHost(const PtyHost&) = delete;
  PtyHost& operator=(const PtyHost&) = delete;

  /// What a client opens; empty while unplugged.
  [[nodiscard]] std::string path() const;
  /// Time on the robot's clock.
  [[nodiscard]] Nanos now() const { return std::chrono::steady_clock::now() - start_; }
  /// How late the robot was, at most, with what was due: computing a body takes time, and so do other programs.
  [[nodiscard]] Nanos worstLag() const { return worst_lag_.load(std::memory_order_relaxed); }
  /// Runs `action` on the robot, which the thread does not touch meanwhile.
  template <class F>
  auto withRobot(F&& action) {
    const Wake wake{*this};
    const std::lock_guard lock{mutex_};
    return action(robot_);
  }

  /// Has the thread itself run `action`, a short one, between its works, and waits for that: the robot never waits for
  /// a caller of low priority. One caller at a time.
  void askRobot(const std::function<void(VirtualRobot&)>& action);

 private:
  struct Wake {
    PtyHost& host;
    ~Wake() { host.wake(); }
  };

  void serve();
  void wake() noexcept;
  void answer();
  void takeInput() noexcept;
  void plugOrUnplug();
  void deliver(Nanos now) noexcept;
  [[nodiscard]] Nanos nextWake(Nanos now) const noexcept;
  void sleepUntil(Nanos when) noexcept;

  VirtualRobot& robot_;
  PtyOptions options_;
  mutable std::mutex mutex_;
  std::unique_ptr<Pty> pty_;
  LatencyTimer latency_;
  std::chrono::steady_clock::time_point start_;
  Nanos last_input_{0};
  int event_fd_ = -1;
  std::atomic<bool> stop_{false};
  std::atomic<Nanos> worst_lag_{Nanos{0}};
  std::atomic<const std::function<void(VirtualRobot&)>*> asked_{nullptr};
  std::atomic<std::uint32_t> answered_{0};
  std::thread thread_;
};

}  // namespace darwinop::hil
