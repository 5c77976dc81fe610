// WebSocket client that reconnects automatically.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "hal/byte_line.hpp"
#include "hal/net/addresses.hpp"

namespace darwinop::web {

struct WebSocketClientConfig {
  net::Ipv4 address = 0x7F000001;  // loopback
  std::uint16_t port = 0;
  std::string path = "/monitor";
  std::string subprotocol;
  std::size_t max_message_bytes = std::size_t{256} * 1024;
  Nanos handshake_timeout{std::chrono::seconds{3}};  // for connecting, and again for the WebSocket handshake
  Nanos idle_timeout{std::chrono::seconds{4}};       // without any data, pongs included
  Nanos retry_interval{std::chrono::seconds{1}};
};

/// Single-threaded and non-blocking: everything happens inside poll(). Received messages are not stored.
class WebSocketClient {
 public:
  /// Called from poll(); must not destroy the client.
  struct Callbacks {
    std::function<void(std::string_view message, bool binary)> received;
    std::function<void(const std::string& reason)> disconnected;  // such as "Connection refused"
  };

  WebSocketClient(WebSocketClientConfig config, Callbacks callbacks);
  ~WebSocketClient();
  WebSocketClient(const WebSocketClient&) = delete;
  WebSocketClient& operator=(const WebSocketClient&) = delete;

  /// Sent now, and again first after each reconnect. A newer request replaces one that is still waiting.
  void request(std::string text);
  /// Runs pending handlers and reconnects if due; call it every few milliseconds.
  void poll();
  [[nodiscard]] bool open() const;

 private:
  class Attempt;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace darwinop::web
