// One WebSocket peer, as those see it who have something to tell it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hal/net/web/outbox.hpp"

namespace darwinop::web {

/// Lives from ChannelUser::opened() to closed().
class Channel {
 public:
  virtual ~Channel() = default;
  /// "192.168.123.5:40312"
  [[nodiscard]] virtual const std::string& name() const = 0;
  /// Never waits; a peer that is too slow loses messages (outbox.hpp).
  virtual void send(Lane lane, Bytes text) = 0;
  virtual void sendBinary(Lane lane, Bytes bytes) = 0;
  /// What waits in lanes 0 to 8 is not sent: it has become wrong.
  virtual void forgetNewest() = 0;
  /// Messages that this peer was too slow for.
  [[nodiscard]] virtual std::uint64_t lost() const = 0;
  /// Shows the peer out; closed() follows, not from inside this call.
  virtual void close(const std::string& why) = 0;
};

/// Called from inside Server::attend(). Lives longer than the server.
class ChannelUser {
 public:
  virtual ~ChannelUser() = default;
  virtual void opened(Channel& channel) = 0;
  virtual void said(Channel& channel, std::string_view message, bool binary) = 0;
  /// The channel is no more when this returns.
  virtual void closed(Channel& channel) noexcept = 0;
};

}  // namespace darwinop::web
