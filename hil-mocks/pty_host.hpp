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
  std::string link;                               // symbolic link to the port, updated after each replug; empty: none
  Nanos latency_timer{0};                         // FTDI latency timer; driver default 16 ms, 0: none
  Nanos at_rest = std::chrono::milliseconds{50};  // maximum body step while idle; longer costs less CPU
};

/// One thread, at SCHED_FIFO 70 if permitted. Status frames are sent when their last byte would have arrived at 1
/// Mbaud, each scheduled on the absolute clock, so that delays do not accumulate.
class PtyHost {
 public:
  /// Starts serving. Throws std::runtime_error if the pseudo terminal or link cannot be created.
  explicit PtyHost(VirtualRobot& robot, const PtyOptions& options = {});
  ~PtyHost();
  PtyHost(const PtyHost&) = delete;
  PtyHost& operator=(const PtyHost&) = delete;

  /// Path for clients; empty while unplugged.
  [[nodiscard]] std::string path() const;
  /// Time on the robot's clock.
  [[nodiscard]] Nanos now() const { return std::chrono::steady_clock::now() - start_; }
  /// Maximum delay of scheduled work, caused by body computation or other programs.
  [[nodiscard]] Nanos worstLag() const { return worst_lag_.load(std::memory_order_relaxed); }
  /// Runs `action` on the robot, excluding the thread.
  template <class F>
  auto withRobot(F&& action) {
    const Wake wake{*this};
    const std::lock_guard lock{mutex_};
    return action(robot_);
  }

  /// Runs a short `action` in the serving thread and waits for it; the robot never waits for a low-priority caller. One
  /// caller at a time.
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
