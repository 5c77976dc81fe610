#include "hal/net/web/caller.hpp"

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

/// One attempt, and what comes of it. Kept alive by the handlers of what it waits for.
class Caller::Call : public std::enable_shared_from_this<Caller::Call> {
 public:
  Call(boost::asio::io_context& context, const CallerConfig& config, const Caller::Ears& ears, const std::string& wish)
      : config_{config}, ears_{ears}, wish_{wish}, stream_{context} {}

  void begin() {
    const tcp::endpoint where{boost::asio::ip::address_v4{config_.address}, config_.port};
    auto& socket = stream_.next_layer();
    socket.expires_after(config_.greeting);
    socket.async_connect(where, [self = shared_from_this(), where](beast::error_code error) {
      if (error) return self->end(error.message());
      self->greet(where);
    });
  }

  void pump() {
    if (!open_ || writing_ || said_ == wish_) return;
    writing_ = true;
    leaving_ = said_ = wish_;
    stream_.async_write(boost::asio::buffer(leaving_),
                        [self = shared_from_this()](beast::error_code error, std::size_t) {
                          self->writing_ = false;
                          if (!error) self->pump();  // of an error the reader hears, too
                        });
  }

  [[nodiscard]] bool open() const { return open_; }
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  void greet(const tcp::endpoint& where) {
    stream_.next_layer().expires_never();  // the WebSocket has times of its own
    websocket::stream_base::timeout times{};
    times.handshake_timeout = config_.greeting;
    times.idle_timeout = config_.patience;
    times.keep_alive_pings = true;
    stream_.set_option(times);
    stream_.set_option(websocket::stream_base::decorator([this](websocket::request_type& request) {
      request.set(beast::http::field::sec_websocket_protocol, config_.subprotocol);
      request.erase(beast::http::field::user_agent);
    }));
    stream_.read_message_max(config_.longest_message);
    stream_.auto_fragment(false);
    // By its number: a monitor knows no names but those that it was told.
    const std::string host = where.address().to_string() + ":" + std::to_string(where.port());
    stream_.async_handshake(answer_, host, config_.path, [self = shared_from_this()](beast::error_code error) {
      if (error == websocket::error::upgrade_declined)
        return self->end("it answers " + std::to_string(self->answer_.result_int()));
      if (error) return self->end(error.message());
      if (self->answer_[beast::http::field::sec_websocket_protocol] != self->config_.subprotocol)
        return self->end("it does not speak " + self->config_.subprotocol);
      self->open_ = true;
      self->pump();
      self->listen();
    });
  }

  void listen() {
    stream_.async_read(buffer_, [self = shared_from_this()](beast::error_code error, std::size_t) {
      if (error) return self->end(error == websocket::error::closed ? "it has ended the connection" : error.message());
      const auto bytes = self->buffer_.cdata();
      self->ears_.heard({static_cast<const char*>(bytes.data()), bytes.size()}, self->stream_.got_binary());
      self->buffer_.clear();
      self->listen();
    });
  }

  void end(const std::string& why) {
    if (std::exchange(ended_, true)) return;
    open_ = false;
    stream_.next_layer().close();
    ears_.broken(why);
  }

  const CallerConfig& config_;
  const Caller::Ears& ears_;
  const std::string& wish_;
  websocket::stream<beast::tcp_stream> stream_;
  websocket::response_type answer_;
  beast::flat_buffer buffer_;
  std::string said_, leaving_;
  bool open_ = false, writing_ = false, ended_ = false;
};

struct Caller::Work {
  Work(CallerConfig given, Ears told) : config{std::move(given)}, ears{std::move(told)} {}

  CallerConfig config;
  Ears ears;
  std::string wish;
  boost::asio::io_context context{1};  // behind what its handlers use: they end with it
  std::shared_ptr<Call> call;
  std::chrono::steady_clock::time_point next{};
};

Caller::Caller(CallerConfig config, Ears ears) : work_{std::make_unique<Work>(std::move(config), std::move(ears))} {}

Caller::~Caller() = default;

void Caller::say(std::string text) {
  work_->wish = std::move(text);
  if (work_->call) work_->call->pump();
}

void Caller::look() {
  const auto now = std::chrono::steady_clock::now();
  if (work_->call && work_->call->ended()) {
    work_->call.reset();
    work_->next = now + work_->config.again;
  }
  if (!work_->call && now >= work_->next) {
    work_->call = std::make_shared<Call>(work_->context, work_->config, work_->ears, work_->wish);
    work_->call->begin();
  }
  constexpr int kAtOnce = 64;  // a monitor that never pauses must not keep us
  work_->context.restart();
  for (int i = 0; i < kAtOnce && work_->context.poll_one() > 0; ++i) {
  }
}

bool Caller::open() const {
  return work_->call && work_->call->open();
}

}  // namespace darwinop::web
