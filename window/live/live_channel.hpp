// Channel of the live comparison, shared by all pages of a window.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/web/channel.hpp"
#include "window/live/live_thread.hpp"

namespace darwinop::window {

/// Runs in the web server's thread. The comparison ends with the last page.
class LiveChannel final : public web::ChannelHandler {
 public:
  using Clock = std::function<Nanos()>;
  static constexpr Nanos kPause{250'000'000};  // between messages

  /// `model`: with which pages begin.
  LiveChannel(LiveThread::Open open, Clock clock, std::string model)
      : thread_{std::move(open)}, clock_{std::move(clock)}, first_{.model = std::move(model), .support = {}} {}

  void opened(web::Channel& channel) override;
  void received(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override;

  /// Sends the residuals to pages when they are due; call it again after pause() or earlier.
  void update();
  [[nodiscard]] Nanos pause() const { return runs_ ? kPause : Nanos{1'000'000'000}; }

 private:
  void send();
  [[nodiscard]] web::Bytes text() const;

  LiveThread thread_;
  Clock clock_;
  LiveSetting first_;
  std::set<web::Channel*> pages_;
  bool runs_ = false;
  Nanos sent_{0};
};

}  // namespace darwinop::window
