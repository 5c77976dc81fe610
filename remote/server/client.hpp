// Connection of one client: receive buffer, send buffer, and what has been logged about it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "hal/byte_line.hpp"
#include "hal/net/socket.hpp"
#include "remote/protocol/request_reader.hpp"
#include "remote/server/reply_builder.hpp"

namespace darwinop::remote {

class Client {
 public:
  Client(net::Socket socket, std::string name, Nanos now)
      : last_request_at{now}, socket_{std::move(socket)}, name_{std::move(name)} {}

  [[nodiscard]] int descriptor() const { return socket_.descriptor(); }
  [[nodiscard]] const std::string& name() const { return name_; }

  /// Reads available bytes. False: the connection has ended, see why().
  [[nodiscard]] bool receive();
  [[nodiscard]] RequestReader::Result next(Request& request, RequestIssues& issues) {
    return reader_.next(request, issues);
  }
  [[nodiscard]] std::size_t garbageBytes() const { return reader_.garbageBytes(); }

  /// Sends a reply in one call, with its NUL unless that would be alone in a segment. False: the connection has ended.
  [[nodiscard]] bool reply(const Request& request, const Reply& reply);
  /// Sends the rest of a reply. False: the connection has ended.
  [[nodiscard]] bool flush();
  [[nodiscard]] bool hasUnsent() const { return sent_ < out_.size(); }
  [[nodiscard]] const std::string& why() const { return why_; }

  Nanos last_request_at;           // time of the last complete request; before the first one, of the connection
  bool drives = false;             // has the lease
  bool has_driven = false;         // has had the lease
  bool extended = false;           // its last request had the extension
  std::string end_request;         // why it must end after its last steps; empty: it may go on
  Nanos session_start{0};          // when it got the lease
  Nanos request_at{0};             // when the present request arrived
  bool has_backlog = false;        // requests were read but not handled, because the rate limit was reached
  std::optional<Request> waiting;  // request that waits for first sensor values or for a cycle
  RequestIssues logged_issues{};   // logged problems of its requests
  StaleValues logged_values{};     // logged stale values of its replies
  bool logged_garbage = false, logged_no_picture = false;

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
