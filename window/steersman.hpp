// Drives the robot in a thread of its own, at the robot's step, as a controller does: no page can make it late.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

#include "managers/motion/page_file.hpp"
#include "remote/robot/link_port.hpp"
#include "window/helm.hpp"

namespace darwinop::window {

class Steersman final : public Helm {
 public:
  /// So long without an order, the window's program itself hangs. Longer than what a page is waited for.
  static constexpr Nanos kDeaf{800'000'000};
  /// For torque to come on.
  static constexpr double kLongestTaking = 30'000;  // ms

  /// `connect` takes the lease, and may take its time. Throws std::runtime_error when that cannot be.
  Steersman(remote::LinkPort::Connect connect, const motion::PageFile& pages);
  /// Who drives lets go.
  ~Steersman() override;
  Steersman(const Steersman&) = delete;
  Steersman& operator=(const Steersman&) = delete;

  void begin() override;
  void order(const Orders& orders) override;
  void stop() override;
  void leave() override;
  [[nodiscard]] Report report() override;

 private:
  void drive();
  void driveUntilTheEnd();
  [[nodiscard]] bool beginsToDrive(const Sensors& seen);
  void tell(State state, const std::string& why);
  /// Nothing: stop.
  [[nodiscard]] std::optional<Orders> newest();

  remote::LinkPort port_;  // of the thread, while there is one
  const motion::PageFile* pages_;
  runtime::MonotonicClock clock_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  // for what follows
  Orders orders_{};
  Report report_{};
  bool leaving_ = false;
  bool deaf_ = false;  // that is why
  Nanos heard_{0};
  std::thread thread_;
};

}  // namespace darwinop::window
