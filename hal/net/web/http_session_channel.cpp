// WebSocket messages of one connection, with Boost.Beast.
#include <string.h>

#include <utility>

#include "hal/net/web/http_session.hpp"
#include "hal/net/web/messages.hpp"

namespace darwinop::web {
namespace {

constexpr std::size_t kMaxCloseReason = 120;  // bytes; RFC 6455: a control frame has room for 123

}  // namespace

void HttpSession::opened(const Endpoint& endpoint) {
  request_.reset();
  read_buffer_.clear();
  handler_ = endpoint.handler;
  context_.logLine(name_ + " is connected");
  handler_->opened(*this);
  closing_ ? sendClose() : read();
}

void HttpSession::read() {
  reading_ = true;
  stream_.async_read(read_buffer_, [self = shared_from_this()](Error error, std::size_t) {
    self->reading_ = false;
    if (!error) return self->received();
    self->end(error == boost::beast::websocket::error::closed ? "" : error.message());
  });
}

void HttpSession::received() {
  const auto now = std::chrono::steady_clock::now();
  if (now - second_ >= std::chrono::seconds{1}) {
    second_ = now;
    messages_ = 0;
  }
  if (++messages_ > context_.config.max_messages_per_s) close(messages::kTooManyMessages);
  if (!closing_) {
    const auto bytes = read_buffer_.cdata();
    handler_->received(*this, {static_cast<const char*>(bytes.data()), bytes.size()}, stream_.got_binary());
  }
  explicit_bzero(read_buffer_.data().data(), read_buffer_.size());  // the message may contain a password
  read_buffer_.clear();
  closing_ ? sendClose() : read();
}

void HttpSession::put(OutgoingMessage message) {
  if (handler_ == nullptr || closing_) return;
  send_queue_.put(std::move(message));
  pump();
}

void HttpSession::pump() {
  if (sending_ || closing_) return;
  sending_ = send_queue_.take();
  if (!sending_) return;
  stream_.binary(sending_->binary);
  const boost::asio::const_buffer bytes{sending_->bytes->data(), sending_->bytes->size()};
  stream_.async_write(bytes, [self = shared_from_this()](Error error, std::size_t) {
    self->sending_.reset();
    if (!error) self->pump();  // the reader gets the error as well
  });
}

void HttpSession::close(const std::string& why) {
  if (handler_ == nullptr || std::exchange(closing_, true)) return;
  context_.logLine(name_ + " is disconnected: " + why);
  close_reason_ = why.substr(0, kMaxCloseReason);
  // Beast 1.74 cannot send a close frame while a read is pending; the TCP connection is closed without one.
  if (reading_) stream_.next_layer().close();
}

void HttpSession::sendClose() {
  const boost::beast::websocket::close_reason reason{boost::beast::websocket::close_code::policy_error, close_reason_};
  stream_.async_close(reason, [self = shared_from_this()](Error) { self->end({}); });
}

void HttpSession::end(const std::string& why) {
  notifyClosed(why);
  stream_.next_layer().close();  // cancels a pending write
}

void HttpSession::notifyClosed(const std::string& why) {
  ChannelHandler* const handler = std::exchange(handler_, nullptr);
  if (handler == nullptr) return;
  try {
    context_.logLine(name_ + " has disconnected" + (why.empty() ? "" : ": " + why));
  } catch (...) {  // out of memory
  }
  handler->closed(*this);
}

}  // namespace darwinop::web
