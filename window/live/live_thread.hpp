// Threads of the live comparison: one reads the robot's cycles, one of low priority simulates the twin. Neither touches
// the robot's loop.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gap/live/live_comparison.hpp"
#include "window/live/cycle_source.hpp"

namespace darwinop::window {

struct LiveSetting {
  std::string model{};  // name or file
  gap::live::Support support = gap::live::Support::kClamped;
  bool operator==(const LiveSetting&) const = default;
};

struct LiveStatus {
  bool runs = false;
  LiveSetting setting;
  std::string error;     // the model cannot be used; empty: it can
  std::string no_robot;  // why there are no cycles; empty: there are
  gap::live::LiveReport report;
  std::uint64_t dropped = 0;  // cycles that were not simulated because this computer is too slow
  double step_s = 0;          // processor time of the twin for one cycle, mean; 0: not known yet
  double period_s = 0;
  /// What the comparison before showed last: of another model, or held in another way.
  std::optional<LiveSetting> setting_before;
  std::optional<gap::live::LiveReport> before;
};

class LiveThread {
 public:
  using Open = std::function<std::unique_ptr<CycleSource>()>;
  static constexpr std::size_t kMostWaiting = 125;  // cycles: 2 s at 16 ms
  static constexpr int kNice = 5;                   // of the twin's thread

  /// `open` is called in the reading thread.
  explicit LiveThread(Open open) : open_{std::move(open)} {}
  ~LiveThread() { stop(); }
  LiveThread(const LiveThread&) = delete;
  LiveThread& operator=(const LiveThread&) = delete;

  /// Begins a comparison, also while another one runs: the same setting begins it again.
  void start(const LiveSetting& setting);
  /// Waits for the step that is being computed.
  void stop();
  [[nodiscard]] LiveStatus status() const;

 private:
  void read();
  void simulate();
  void begin(const LiveSetting& setting);
  void put(const gap::live::LiveCycle& cycle);
  [[nodiscard]] std::deque<gap::live::LiveCycle> takeAll();
  void advance(const std::deque<gap::live::LiveCycle>& cycles);
  void publish(const std::string& error);

  Open open_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<gap::live::LiveCycle> waiting_;
  std::optional<LiveSetting> wanted_;
  LiveStatus status_;
  std::atomic<bool> ends_{false};
  std::thread reader_, simulator_;

  // Of the simulating thread.
  std::optional<twin::Model> model_;
  std::optional<gap::live::LiveComparison> comparison_;
  std::int64_t period_ns_ = 0;
  gap::live::Support support_{};
  double spent_s_ = 0;
  std::uint64_t stepped_ = 0;
};

}  // namespace darwinop::window
