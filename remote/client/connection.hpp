// Client connection: one request and one reply at a time, with bounded waits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/net/socket.hpp"
#include "remote/protocol/reply_reader.hpp"
#include "remote/protocol/request_writer.hpp"

namespace darwinop::remote {

class Connection {
 public:
  enum class State : std::uint8_t { kClosed, kConnecting, kOpen };

  /// Closes the current connection and starts connecting; host byte order.
  void connect(std::uint32_t address, std::uint16_t port);
  void close(const std::string& why);

  [[nodiscard]] State state() const { return state_; }
  /// Why it is closed, such as "Connection refused".
  [[nodiscard]] const std::string& why() const { return why_; }

  /// Requires that the reply to the previous request has been read.
  void send(const Request& request);
  [[nodiscard]] bool awaitsReply() const { return asked_.has_value(); }

  /// Waits at most `longest` for socket events and handles them. False: interrupted by a signal.
  bool wait(Nanos longest);
  /// The reply if it is complete; its picture and sensors are valid until the next wait(). Nullopt also if the
  /// connection
  /// has ended.
  [[nodiscard]] std::optional<Reply> reply();

 private:
  void handle(short events);
  void flush();
  void receive();

  net::Socket socket_;
  State state_ = State::kClosed;
  std::string why_;
  RequestBuffer buffer_{};
  std::span<const std::uint8_t> out_;  // not sent yet
  ReplyReader reader_;
  std::optional<Request> asked_;
};

}  // namespace darwinop::remote
