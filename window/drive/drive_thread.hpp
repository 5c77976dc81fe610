// Drives the robot from its own thread, once per cycle like a controller, independent of the page's timing.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "managers/motion/page_file.hpp"
#include "runtime/clock.hpp"
#include "runtime/driver_session.hpp"
#include "window/drive/drive_interface.hpp"

namespace darwinop::window {

class DriveThread final : public DriveInterface {
 public:
  /// Acquires the lease and may block; throws std::runtime_error on failure.
  using Connect = std::function<std::unique_ptr<runtime::RobotLink>()>;
  /// Without a request for this time the web server's thread hangs. Longer than the page's heartbeat timeout.
  static constexpr Nanos kRequestTimeout{800'000'000};

  /// `pages` must outlive it.
  DriveThread(Connect connect, const motion::PageFile& pages) : connect_{std::move(connect)}, pages_{&pages} {}
  /// Ends an open session.
  ~DriveThread() override;
  DriveThread(const DriveThread&) = delete;
  DriveThread& operator=(const DriveThread&) = delete;

  void start() override;
  void request(const DriveRequests& requests) override;
  void stop() override { handle(DriveEvent::kStopAsked); }
  void finish() override { handle(DriveEvent::kFinishAsked); }
  [[nodiscard]] Report report() override;

 private:
  void driveSession();
  void runCycles(runtime::DriverSession& session, Commands& commands);
  /// The requests of this cycle. Nullopt: hold.
  [[nodiscard]] std::optional<DriveRequests> takeRequests();
  /// `why` is reported if the event changes the state.
  void handle(DriveEvent event, const std::string& why = {});
  void handleLocked(DriveEvent event, const std::string& why);

  Connect connect_;
  const motion::PageFile* pages_;
  runtime::MonotonicClock clock_;
  std::mutex mutex_;  // guards the members below
  DriveRequests requests_{};
  Report report_{};
  Nanos last_request_{0};
  std::thread thread_;
};

}  // namespace darwinop::window
