// Reconnecting WebSocket client, with Boost.Beast.
#include "hal/net/web/websocket_client.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <utility>

namespace darwinop::web {
namespace {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using tcp = boost::asio::ip::tcp;

}  // namespace

/// One connection attempt and the connection that results. Pending handlers keep it alive.
class WebSocketClient::Attempt : public std::enable_shared_from_this<WebSocketClient::Attempt> {
 public:
  Attempt(boost::asio::io_context& context, const WebSocketClientConfig& config,
          const WebSocketClient::Callbacks& callbacks, const std::string& request)
      : config_{config}, callbacks_{callbacks}, request_{request}, stream_{context} {}

  void start() {
    const tcp::endpoint where{boost::asio::ip::address_v4{config_.address}, config_.port};
    auto& socket = stream_.next_layer();
    socket.expires_after(config_.handshake_timeout);
    socket.async_connect(where, [self = shared_from_this(), where](beast::error_code error) {
      if (error) return self->end(error.message());
      self->handshake(where);
    });
  }

  void pump() {
    if (!open_ || writing_ || sent_ == request_) return;
    writing_ = true;
    sending_ = sent_ = request_;
    stream_.async_write(boost::asio::buffer(sending_),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->writing_ = false;
                          if (!error) self->pump();  // the reader gets the error as well
                        });
  }

  [[nodiscard]] bool open() const { return open_; }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  void handshake(const tcp::endpoint& where) {
    stream_.next_layer().expires_never();  // the WebSocket has its own timeouts
    websocket::stream_base::timeout times{};
    times.handshake_timeout = config_.handshake_timeout;
    times.idle_timeout = config_.idle_timeout;
    times.keep_alive_pings = true;
    stream_.set_option(times);
    stream_.set_option(websocket::stream_base::decorator([this](websocket::request_type& head) {
      head.set(beast::http::field::sec_websocket_protocol, config_.subprotocol);
      head.erase(beast::http::field::user_agent);
    }));
    stream_.read_message_max(config_.max_message_bytes);
    stream_.auto_fragment(false);
    // By IP address: a monitor refuses host names that it was not configured with.
    const std::string host = where.address().to_string() + ":" + std::to_string(where.port());
    stream_.async_handshake(response_, host, config_.path, [self = shared_from_this()](beast::error_code error) {
      if (error == websocket::error::upgrade_declined)
        return self->end("HTTP status " + std::to_string(self->response_.result_int()));
      if (error) return self->end(error.message());
      if (self->response_[beast::http::field::sec_websocket_protocol] != self->config_.subprotocol)
        return self->end("the server does not offer the subprotocol " + self->config_.subprotocol);
      self->open_ = true;
      self->pump();
      self->read();
    });
  }

  void read() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error)
        return self->end(error == websocket::error::closed ? "the server closed the connection" : error.message());
      const auto bytes = self->buffer_.cdata();
      self->callbacks_.received({static_cast<const char*>(bytes.data()), bytes.size()}, self->stream_.got_binary());
      self->buffer_.clear();
      self->read();
    });
  }

  void end(const std::string& why) {
    if (std::exchange(ended_, true)) return;
    open_ = false;
    stream_.next_layer().close();
    callbacks_.disconnected(why);
  }

  const WebSocketClientConfig& config_;
  const WebSocketClient::Callbacks& callbacks_;
  const std::string& request_;
  websocket::stream<beast::tcp_stream> stream_;
  websocket::response_type response_;
  beast::flat_buffer buffer_;
  std::string sent_, sending_;
  bool open_ = false, writing_ = false, ended_ = false;
};

struct WebSocketClient::Impl {
  Impl(WebSocketClientConfig given, Callbacks given_callbacks)
      : config{std::move(given)}, callbacks{std::move(given_callbacks)} {}

  WebSocketClientConfig config;
  Callbacks callbacks;
  std::string request;
  boost::asio::io_context context{1};  // declared last of what its handlers use: destroys them first
  std::shared_ptr<Attempt> call;
  std::chrono::steady_clock::time_point next{};
};

WebSocketClient::WebSocketClient(WebSocketClientConfig config, Callbacks callbacks)
    : impl_{std::make_unique<Impl>(std::move(config), std::move(callbacks))} {}

WebSocketClient::~WebSocketClient() = default;

void WebSocketClient::request(std::string text) {
  impl_->request = std::move(text);
  if (impl_->call) impl_->call->pump();
}

void WebSocketClient::poll() {
  const auto now = std::chrono::steady_clock::now();
  if (impl_->call && impl_->call->ended()) {
    impl_->call.reset();
    impl_->next = now + impl_->config.retry_interval;
  }
  if (!impl_->call && now >= impl_->next) {
    impl_->call = std::make_shared<Attempt>(impl_->context, impl_->config, impl_->callbacks, impl_->request);
    impl_->call->start();
  }
  constexpr int kAtOnce = 64;  // handlers at once: a server that sends without pause must not block the caller
  impl_->context.restart();
  for (int i = 0; i < kAtOnce && impl_->context.poll_one() > 0; ++i) {
  }
}

bool WebSocketClient::open() const {
  return impl_->call && impl_->call->open();
}

}  // namespace darwinop::web
