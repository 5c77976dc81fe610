// One connection: a request, then an answer or a WebSocket. With Boost.Beast, so only for this folder's own files.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket.hpp>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "hal/net/bounded_log.hpp"
#include "hal/net/web/channel.hpp"
#include "hal/net/web/server.hpp"
#include "hal/net/web/wiping_stream.hpp"

namespace darwinop::web {

struct Endpoint {
  std::string subprotocol;
  ChannelUser* user = nullptr;
};

class Visit;

/// What all visits share; lives longer than they do.
struct House {
  ServerConfig config;
  net::BoundedLog log;
  std::map<std::string, Page, std::less<>> pages;
  std::map<std::string, Endpoint, std::less<>> endpoints;
  std::size_t connections = 0, channels = 0;
  std::list<Visit*> guests{};  // connections that are no channel, the oldest one first

  void say(const std::string& line);
  /// False: there are as many connections as may be, and all are channels. Else the oldest guest may have had to go.
  [[nodiscard]] bool makeRoom();
};

/// Kept alive by the handlers of what it waits for: when it waits for nothing any more it is gone.
class Visit final : public Channel, public std::enable_shared_from_this<Visit> {
 public:
  Visit(House& house, boost::asio::ip::tcp::socket socket, std::string name);
  ~Visit() override;
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  void begin();
  /// For a newer guest. It is gone when the handlers of what it waits for have run.
  void giveWay();

  [[nodiscard]] const std::string& name() const override { return name_; }
  void send(Lane lane, Bytes text) override { put({lane, false, std::move(text)}); }
  void sendBinary(Lane lane, Bytes bytes) override { put({lane, true, std::move(bytes)}); }
  void forgetNewest() override { outbox_.forgetNewest(); }
  [[nodiscard]] std::uint64_t lost() const override { return outbox_.lost(); }
  void close(const std::string& why) override;

 private:
  using Error = boost::beast::error_code;
  using Status = boost::beast::http::status;
  using Reply = boost::beast::http::response<boost::beast::http::string_body>;

  void answer();
  void reply(Status status, Page page, bool body = true);
  void refuse(Status status, const std::string& why);
  void upgrade(const Endpoint& endpoint);
  void opened(const Endpoint& endpoint);
  void listen();
  void heard();
  void put(Parcel parcel);
  void pump();
  void sayFarewell();
  void end(const std::string& why);
  void leave(const std::string& why);

  House& house_;
  std::string name_;
  boost::beast::websocket::stream<WipingStream> stream_;
  boost::beast::flat_buffer heard_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::empty_body>> request_;
  Reply reply_;
  ChannelUser* user_ = nullptr;  // while it is an open channel
  bool has_seat_ = false;        // counts among the channels
  bool counts_ = true;           // among the connections
  Outbox outbox_;
  std::optional<Parcel> leaving_;  // is being sent
  bool reading_ = false, closing_ = false;
  std::string farewell_;
  std::chrono::steady_clock::time_point second_{};
  int messages_ = 0;  // in this second
};

}  // namespace darwinop::web
