// One connection: what came, what has still to go out, what was already said about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/byte_line.hpp"
#include "hal/net/socket.hpp"
#include "remote/protocol/request_reader.hpp"
#include "remote/server/answer.hpp"

namespace darwinop::remote {

class Client {
 public:
  Client(net::Socket socket, std::string name, Nanos now)
      : heard{now}, socket_{std::move(socket)}, name_{std::move(name)} {}

  [[nodiscard]] int descriptor() const { return socket_.descriptor(); }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Reads what is there. False: the connection has ended; why() says how.
  [[nodiscard]] bool receive();
  [[nodiscard]] RequestReader::Found next(Request& request, Oddities& oddities) {
    return reader_.next(request, oddities);
  }
  [[nodiscard]] std::size_t garbageBytes() const { return reader_.garbageBytes(); }

  /// A reply leaves in one call, with its NUL unless that would travel alone. False: the connection has ended.
  [[nodiscard]] bool reply(const Request& request, const Reply& reply);
  /// Sends what the network did not take yet. False: the connection has ended.
  [[nodiscard]] bool flush();
  [[nodiscard]] bool owes() const { return sent_ < out_.size(); }
  [[nodiscard]] const std::string& why() const { return why_; }

  Nanos heard;                   // its last whole request; before the first one, when it came
  bool drives = false;           // holds the lease
  bool driven = false;           // has held it
  Nanos began{0};                // when it got the lease
  Nanos asked{0};                // when the request came that is being answered
  bool more = false;             // requests that were read and not looked at: the server had no allowance left
  std::optional<Request> waits;  // for values that the robot has not told yet, or for a cycle
  Oddities told{};               // what has been said of its requests
  Doubts told_values{};          // and of the replies
  bool told_garbage = false, told_no_picture = false;

 private:
  [[nodiscard]] bool ended(const std::string& why) {
    why_ = why;
    return false;
  }

  net::Socket socket_;
  std::string name_, why_;
  RequestReader reader_;
  std::vector<std::uint8_t> out_;
  std::size_t sent_ = 0;
};

}  // namespace darwinop::remote
