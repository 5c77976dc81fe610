// One HTTP connection: a request, then a response or a WebSocket. Includes Boost.Beast; private to this folder.
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
  ChannelHandler* handler = nullptr;
};

class HttpSession;

/// State shared by all sessions; outlives them.
struct ServerContext {
  WebServerConfig config;
  net::BoundedLog log;
  std::map<std::string, WebPage, std::less<>> pages;
  std::map<std::string, Endpoint, std::less<>> endpoints;
  std::size_t connections = 0, channels = 0;
  std::list<HttpSession*> idle_sessions{};  // connections that are not channels, oldest first

  void logLine(const std::string& line);
  /// Closes the oldest non-channel connection if the limit is reached. False: all connections are channels.
  [[nodiscard]] bool makeRoom();
};

/// Pending handlers keep it alive; it is destroyed when none is left.
class HttpSession final : public Channel, public std::enable_shared_from_this<HttpSession> {
 public:
  HttpSession(ServerContext& shared, boost::asio::ip::tcp::socket socket, std::string name);
  ~HttpSession() override;
  HttpSession(const HttpSession&) = delete;
  HttpSession& operator=(const HttpSession&) = delete;

  void start();
  /// Closes it for a newer connection. It is destroyed when its pending handlers have run.
  void evict();

  [[nodiscard]] const std::string& name() const override { return name_; }
  void send(Lane lane, Bytes text) override { put({lane, false, std::move(text)}); }
  void sendBinary(Lane lane, Bytes bytes) override { put({lane, true, std::move(bytes)}); }
  void discardQueued() override { send_queue_.discardQueued(); }
  [[nodiscard]] std::uint64_t lost() const override { return send_queue_.lost(); }
  void close(const std::string& why) override;

 private:
  using Error = boost::beast::error_code;
  using Status = boost::beast::http::status;
  using Reply = boost::beast::http::response<boost::beast::http::string_body>;

  void respond();
  void answerUnreadable(Error error);
  void reply(Status status, WebPage page, bool body = true);
  void refuse(Status status, const std::string& why);
  void upgrade(const Endpoint& endpoint);
  void opened(const Endpoint& endpoint);
  void read();
  void received();
  void put(OutgoingMessage message);
  void pump();
  void sendClose();
  void end(const std::string& why);
  void notifyClosed(const std::string& why);

  ServerContext& context_;
  std::string name_;
  boost::beast::websocket::stream<WipingStream> stream_;
  boost::beast::flat_buffer read_buffer_;
  std::optional<boost::beast::http::request_parser<boost::beast::http::empty_body>> request_;
  Reply reply_;
  ChannelHandler* handler_ = nullptr;  // set while it is an open channel
  bool is_channel_ = false;            // counted in ServerContext::channels
  bool is_counted_ = true;             // counted in ServerContext::connections
  SendQueue send_queue_;
  std::optional<OutgoingMessage> sending_;  // being written
  bool reading_ = false, closing_ = false;
  std::string close_reason_;
  std::chrono::steady_clock::time_point second_{};
  int messages_ = 0;  // received in this second
};

}  // namespace darwinop::web
