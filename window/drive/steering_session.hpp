// Session of a page on the steering channel: one page at a time drives the robot, while its heartbeat arrives.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/web/channel.hpp"
#include "window/drive/drive_interface.hpp"
#include "window/drive/steering_message.hpp"

namespace darwinop::window {

inline constexpr const char* kSteeringProtocol = "darwinop-steering.1";

/// Runs in the web server's thread. Commands pass through safety, as those of a controller.
class SteeringSession final : public web::ChannelHandler {
 public:
  using Clock = std::function<Nanos()>;
  /// Heartbeat timeout: the page is closed, suspended or disconnected. Pages send ten messages a second.
  static constexpr Nanos kHeartbeatTimeout{500'000'000};

  SteeringSession(DriveInterface& drive, Clock clock) : drive_{drive}, clock_{std::move(clock)} {}
  /// Ends an open session.
  ~SteeringSession() override;

  void opened(web::Channel& channel) override;
  void received(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override;

  /// Forwards requests, or ends the session on a timeout. Call it about once per cycle.
  void update();
  [[nodiscard]] bool drives() const { return driver_ != nullptr; }

 private:
  void take(web::Channel& channel);
  void stop(const web::Channel& channel);
  /// The takeover is complete, also before update() reports it to the page.
  [[nodiscard]] bool hasTorque();
  void sendStatus(const DriveStatus& status);
  void release(const std::string& why);
  /// Sends `text` once the robot holds. Until then the page shows that the session is ending.
  void awaitEnd(web::Channel& channel, const std::string& text);
  void sendEnd();

  DriveInterface& drive_;
  Clock clock_;
  web::Channel* driver_ = nullptr;                  // page that drives or is taking over
  bool is_driving_ = false;                         // takeover is complete
  std::map<web::Channel*, std::string> await_end_;  // pages, with the text that each gets when the robot holds
  Nanos last_heartbeat_{0};
  DriveRequests requests_{};  // since the last update()
  DriveStatus sent_status_{};
};

}  // namespace darwinop::window
