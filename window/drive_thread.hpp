// Drives the robot from its own thread, once per cycle like a controller, independent of the page's timing.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>
#include <thread>

#include "managers/motion/page_file.hpp"
#include "remote/robot/link_port.hpp"
#include "window/drive_interface.hpp"

namespace darwinop::window {

class DriveThread final : public DriveInterface {
 public:
  /// Without a request for this time the web server's thread hangs. Longer than the page's heartbeat timeout.
  static constexpr Nanos kRequestTimeout{800'000'000};
  /// Timeout for torque to come on.
  static constexpr double kTakeoverTimeoutMs = 30'000;  // ms

  /// `connect` takes the lease and may block; it throws std::runtime_error on failure.
  DriveThread(remote::LinkPort::Connect connect, const motion::PageFile& pages);
  /// Ends an open session.
  ~DriveThread() override;
  DriveThread(const DriveThread&) = delete;
  DriveThread& operator=(const DriveThread&) = delete;

  void start() override;
  void request(const DriveRequests& requests) override;
  void stop() override;
  void finish() override;
  [[nodiscard]] Report report() override;

 private:
  void drive();
  void runCycles();
  [[nodiscard]] bool checkDriven(const Sensors& seen);
  void setState(State state, const std::string& why);
  /// Nullopt: stop.
  [[nodiscard]] std::optional<DriveRequests> takeRequests();

  remote::LinkPort port_;  // used by the thread while it runs
  const motion::PageFile* pages_;
  runtime::MonotonicClock clock_;
  std::atomic<bool> stop_{false};
  std::mutex mutex_;  // guards the members below
  DriveRequests requests_{};
  Report report_{};
  bool finishing_ = false;
  bool timed_out_ = false;
  Nanos last_request_{0};
  std::thread thread_;
};

}  // namespace darwinop::window
