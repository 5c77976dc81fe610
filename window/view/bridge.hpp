// Forwards the monitor channel of a remote robot to the page, so that the browser connects to the window's program
// only.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/addresses.hpp"
#include "hal/net/web/channel.hpp"
#include "hal/net/web/websocket_client.hpp"
#include "monitor/subscription.hpp"

namespace darwinop::window {

/// One connection per page, because each has its own subscription; slow pages lose messages as with a local monitor.
/// Runs in the web server's thread.
class Bridge final : public web::ChannelHandler {
 public:
  /// `name`: of the monitor, for messages: "192.168.123.1:5024".
  Bridge(net::Ipv4 address, std::uint16_t port, std::string name)
      : address_{address}, port_{port}, name_{std::move(name)} {}

  void opened(web::Channel& channel) override;
  void received(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override { connections_.erase(&channel); }

  /// Sends the final message to all pages: why the program ends.
  void sendEnd(const std::string& why);

  /// Handles events; call it again after pause() or earlier.
  void update();
  [[nodiscard]] Nanos pause() const;

 private:
  struct Connection {
    std::unique_ptr<web::WebSocketClient> client;
    monitor::Subscription subscription{};
    std::string gone_reason;  // reason sent last; empty while connected
  };

  void forward(web::Channel& channel, std::string_view message, bool binary);
  void disconnected(web::Channel& channel, const std::string& why);

  net::Ipv4 address_;
  std::uint16_t port_;
  std::string name_;
  std::map<web::Channel*, Connection> connections_;
};

}  // namespace darwinop::window
