// A connection to a server: one request and one reply at a time, and nothing waits longer than it is told.
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

  /// Begins to connect, and closes what was there.
  void connect(std::uint32_t address, std::uint16_t port);
  void close(const std::string& why);

  [[nodiscard]] State state() const { return state_; }
  /// Why it is closed, a few words: "Connection refused".
  [[nodiscard]] const std::string& why() const { return why_; }

  /// Not before the reply to the one before has been read.
  void send(const Request& request);
  [[nodiscard]] bool awaitsReply() const { return asked_.has_value(); }

  /// Waits at most that long for anything to come of what is under way. False: a signal came.
  bool wait(Nanos longest);
  /// The reply when it is there; its picture and sensors stay until the next wait(). None, too, when the connection
  /// has ended.
  [[nodiscard]] std::optional<Reply> reply();

 private:
  void look(short events);
  void flush();
  void receive();

  net::Socket socket_;
  State state_ = State::kClosed;
  std::string why_;
  RequestBuffer buffer_{};
  std::span<const std::uint8_t> out_;  // what the network has not taken yet
  ReplyReader reader_;
  std::optional<Request> asked_;
};

}  // namespace darwinop::remote
