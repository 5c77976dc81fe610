// A small web server for observers: fixed pages by GET, and WebSockets whose peers may be as slow as they like.
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
#include "hal/net/web/entry.hpp"

namespace darwinop::web {

struct ServerConfig {
  net::Ipv4 address = 0x7F000001;  // loopback
  std::uint16_t port = 0;          // 0: any that is free
  std::vector<net::Network> allowed{{0x7F000000, 0xFF000000}};
  EntryRules entry{};
  std::size_t most_channels = 8;      // one more: 503
  std::size_t most_connections = 32;  // one more: the oldest one that is no channel is closed
  std::size_t longest_message = 4096;
  int most_messages = 50;                    // a second, of one peer; it is shown out then
  Nanos greeting{std::chrono::seconds{5}};   // for a whole request
  Nanos patience{std::chrono::seconds{20}};  // without a word, not even an answer to a ping
};

struct Page {
  std::string type;  // "text/html; charset=utf-8"
  std::string body;
  std::string policy = {};  // Content-Security-Policy; empty: nothing but what comes from here
};

/// One thread: whoever calls attend(). Nothing here waits for a peer.
class Server {
 public:
  using Say = std::function<void(const std::string&)>;

  /// Listens from now on. Throws std::runtime_error with what to do. `say` is told at most 30 lines a minute.
  Server(const ServerConfig& config, Say say);
  /// Channels that are open are closed.
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Answers GET and HEAD of exactly this path. Before the first attend().
  void serve(const std::string& path, Page page);
  /// A WebSocket endpoint; a peer must offer `subprotocol`. Before the first attend().
  void channel(const std::string& path, const std::string& subprotocol, ChannelUser& user);

  /// Waits at most `longest` for something to happen, and sees to it.
  void attend(Nanos longest);

  [[nodiscard]] std::uint16_t port() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace darwinop::web
