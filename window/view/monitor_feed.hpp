// Source of the page's monitor channel: a local runtime's shared memory or a remote monitor.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "monitor/monitor.hpp"
#include "window/view/bridge.hpp"

namespace darwinop::window {

class MonitorFeed {
 public:
  explicit MonitorFeed(std::unique_ptr<monitor::Monitor> local) : local_{std::move(local)} {}
  explicit MonitorFeed(std::unique_ptr<Bridge> remote) : remote_{std::move(remote)} {}

  web::ChannelHandler& handler() {
    if (local_) return *local_;
    return *remote_;
  }
  void update() { local_ ? local_->update() : remote_->update(); }
  [[nodiscard]] Nanos pause() const { return local_ ? local_->pause() : remote_->pause(); }
  void notice(const std::string& text) {
    if (local_) local_->notice(text);
  }
  void sendEnd(const std::string& why) {
    if (remote_) remote_->sendEnd(why);
  }

 private:
  std::unique_ptr<monitor::Monitor> local_;
  std::unique_ptr<Bridge> remote_;
};

}  // namespace darwinop::window
