// Small web server: static pages by GET, and WebSockets with bounded queues for slow peers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hal/byte_line.hpp"
#include "hal/net/addresses.hpp"
#include "hal/net/web/channel.hpp"
#include "hal/net/web/request_origin.hpp"

namespace darwinop::web {

struct WebServerConfig {
  net::Ipv4 address = 0x7F000001;  // loopback
  std::uint16_t port = 0;          // 0: any free port
  std::vector<net::Network> allowed{{0x7F000000, 0xFF000000}};
  OriginRules origin{};
  std::size_t max_channels = 8;      // beyond it: status 503
  std::size_t max_connections = 32;  // beyond it: closes the oldest connection that is not a channel
  std::size_t max_message_bytes = 4096;
  int max_messages_per_s = 50;                       // per second from one peer; beyond it the peer is disconnected
  Nanos handshake_timeout{std::chrono::seconds{5}};  // for a whole request, and for the WebSocket handshake
  Nanos idle_timeout{std::chrono::seconds{20}};      // without any data, pongs included
};

struct WebPage {
  std::string type;  // "text/html; charset=utf-8"
  std::string body;
  std::string policy = {};  // Content-Security-Policy; empty: default-src 'self'
};

/// Single-threaded: everything happens inside poll(), which never blocks on a peer.
class WebServer {
 public:
  using Log = std::function<void(const std::string&)>;

  /// Listens at once. Throws std::runtime_error with the remedy. `log` gets at most 30 lines a minute.
  WebServer(const WebServerConfig& config, Log log);
  /// Closes open channels.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Answers GET and HEAD of exactly this path. Call before the first poll().
  void serve(const std::string& path, WebPage page);
  /// Adds a WebSocket endpoint; a peer must offer `subprotocol`. Call before the first poll().
  void channel(const std::string& path, const std::string& subprotocol, ChannelHandler& handler);

  /// Waits at most `longest` for events and handles them.
  void poll(Nanos longest);

  [[nodiscard]] std::uint16_t port() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace darwinop::web
