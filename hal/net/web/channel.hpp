// Interface of one WebSocket connection to the code that publishes on it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hal/net/web/send_queue.hpp"

namespace darwinop::web {

/// Valid from ChannelHandler::opened() until closed() returns.
class Channel {
 public:
  virtual ~Channel() = default;
  /// "192.168.123.5:40312"
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// Non-blocking; a peer that is too slow loses messages (send_queue.hpp).
  virtual void send(Lane lane, Bytes text) = 0;
  virtual void sendBinary(Lane lane, Bytes bytes) = 0;
  /// Discards what is queued in lanes 0 to 8, because it is no longer true.
  virtual void discardQueued() = 0;
  /// Messages replaced or dropped because this peer is too slow.
  [[nodiscard]] virtual std::uint64_t lost() const = 0;
  /// Closes the connection with this reason; closed() follows, not from inside this call.
  virtual void close(const std::string& why) = 0;
};

/// Called from inside WebServer::poll(). Must outlive the server.
class ChannelHandler {
 public:
  virtual ~ChannelHandler() = default;
  virtual void opened(Channel& channel) = 0;
  virtual void received(Channel& channel, std::string_view message, bool binary) = 0;
  /// The channel is destroyed after this returns.
  virtual void closed(Channel& channel) noexcept = 0;
};

}  // namespace darwinop::web
