#include "hal/net/web/visit.hpp"

#include <string.h>

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <utility>

namespace darwinop::web {
namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;

constexpr std::uint32_t kLongestHead = 8192;
constexpr std::size_t kLongestFarewell = 120;  // RFC 6455: a control frame has room for 123

std::string_view viewOf(beast::string_view text) {
  return {text.data(), text.size()};
}

/// "a, b, c" has b.
bool listHas(std::string_view list, std::string_view word) {
  while (!list.empty()) {
    const std::size_t comma = list.find(',');
    std::string_view item = list.substr(0, comma);
    while (!item.empty() && (item.front() == ' ' || item.front() == '\t')) item.remove_prefix(1);
    while (!item.empty() && (item.back() == ' ' || item.back() == '\t')) item.remove_suffix(1);
    if (item == word) return true;
    list = comma == std::string_view::npos ? std::string_view{} : list.substr(comma + 1);
  }
  return false;
}

}  // namespace

void House::say(const std::string& line) {
  log.line(line, std::chrono::steady_clock::now().time_since_epoch());
}

bool House::makeRoom() {
  if (connections < config.most_connections) return true;
  if (guests.empty()) return false;
  guests.front()->giveWay();
  return true;
}

Visit::Visit(House& house, boost::asio::ip::tcp::socket socket, std::string name)
    : house_{house},
      name_{std::move(name)},
      stream_{std::move(socket)},
      heard_{house.config.longest_message + kLongestHead} {
  ++house_.connections;
  house_.guests.push_back(this);
}

Visit::~Visit() {
  leave({});
  if (has_seat_) --house_.channels;
  if (counts_) --house_.connections;
  house_.guests.remove(this);
}

void Visit::giveWay() {
  house_.say(name_ + " has to go for a newer connection: it had " + (request_->is_done() ? "" : "not ") +
             "sent its request");
  house_.guests.remove(this);
  --house_.connections;
  counts_ = false;
  stream_.next_layer().close();
}

void Visit::begin() {
  request_.emplace();
  request_->header_limit(kLongestHead);
  request_->body_limit(0);
  stream_.next_layer().expires_after(house_.config.greeting);
  http::async_read(stream_.next_layer(), heard_, *request_, [self = shared_from_this()](Error error, std::size_t) {
    if (!error) self->answer();
  });
}

void Visit::answer() {
  const auto& asked = request_->get();
  Knock knock{.host = viewOf(asked[http::field::host]), .origin = {}};
  if (const auto origin = asked.find(http::field::origin); origin != asked.end())
    knock.origin = viewOf(origin->value());
  if (asked.count(http::field::host) != 1 || asked.count(http::field::origin) > 1)
    return refuse(Status::bad_request, "one Host, and at most one Origin");
  if (const std::string why = refusal(house_.config.entry, knock); !why.empty()) return refuse(Status::forbidden, why);

  const std::string_view path = viewOf(asked.target()).substr(0, asked.target().find('?'));
  const auto endpoint = house_.endpoints.find(path);
  if (websocket::is_upgrade(asked)) {
    if (endpoint == house_.endpoints.end()) return refuse(Status::not_found, "there is no channel of that name");
    return upgrade(endpoint->second);
  }
  if (asked.method() != http::verb::get && asked.method() != http::verb::head)
    return refuse(Status::method_not_allowed, "GET and HEAD only");
  if (endpoint != house_.endpoints.end())
    return refuse(Status::upgrade_required, "this is a WebSocket of the subprotocol " + endpoint->second.subprotocol);
  const auto page = house_.pages.find(path);
  if (page == house_.pages.end()) return refuse(Status::not_found, "there is nothing of that name");
  reply(Status::ok, page->second, asked.method() == http::verb::get);
}

void Visit::refuse(Status status, const std::string& why) {
  house_.say(name_ + " was refused: " + why);
  reply(status, {"text/plain; charset=utf-8", why + "\n"}, request_->get().method() != http::verb::head);
}

void Visit::reply(Status status, Page page, bool body) {
  reply_ = Reply{status, 11};
  reply_.set(http::field::content_type, page.type);
  reply_.set(http::field::cache_control, "no-store");
  reply_.set("X-Content-Type-Options", "nosniff");
  reply_.set("X-Frame-Options", "DENY");
  reply_.set("Referrer-Policy", "no-referrer");
  reply_.set("Content-Security-Policy", page.policy.empty() ? "default-src 'self'" : page.policy);
  if (status == Status::upgrade_required) reply_.set(http::field::upgrade, "websocket");
  reply_.keep_alive(false);
  reply_.content_length(page.body.size());
  if (body) reply_.body() = std::move(page.body);
  stream_.next_layer().expires_after(house_.config.patience);
  http::async_write(stream_.next_layer(), reply_, [self = shared_from_this()](Error, std::size_t) {
    Error ignored;
    self->stream_.next_layer().socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  });
}

void Visit::upgrade(const Endpoint& endpoint) {
  const auto& asked = request_->get();
  if (!listHas(viewOf(asked[http::field::sec_websocket_protocol]), endpoint.subprotocol))
    return refuse(Status::bad_request, "offer the subprotocol " + endpoint.subprotocol);
  if (house_.channels >= house_.config.most_channels)
    return refuse(Status::service_unavailable,
                  "there are " + std::to_string(house_.channels) + " observers, no more can come");
  ++house_.channels;
  has_seat_ = true;
  house_.guests.remove(this);
  stream_.next_layer().expires_never();  // the WebSocket has times of its own
  websocket::stream_base::timeout times{};
  times.handshake_timeout = house_.config.greeting;
  times.idle_timeout = house_.config.patience;
  times.keep_alive_pings = true;
  stream_.set_option(times);
  stream_.set_option(
      websocket::stream_base::decorator([name = endpoint.subprotocol](websocket::response_type& response) {
        response.set(http::field::sec_websocket_protocol, name);
        response.erase(http::field::server);
      }));
  stream_.read_message_max(house_.config.longest_message);
  stream_.auto_fragment(false);
  stream_.async_accept(asked, [self = shared_from_this(), &endpoint](Error error) {
    if (!error) self->opened(endpoint);
  });
}

void Visit::opened(const Endpoint& endpoint) {
  request_.reset();
  heard_.clear();
  user_ = endpoint.user;
  house_.say(name_ + " looks on");
  user_->opened(*this);
  closing_ ? sayFarewell() : listen();
}

void Visit::listen() {
  reading_ = true;
  stream_.async_read(heard_, [self = shared_from_this()](Error error, std::size_t) {
    self->reading_ = false;
    if (!error) return self->heard();
    self->end(error == websocket::error::closed ? "" : error.message());
  });
}

void Visit::heard() {
  const auto now = std::chrono::steady_clock::now();
  if (now - second_ >= std::chrono::seconds{1}) {
    second_ = now;
    messages_ = 0;
  }
  if (++messages_ > house_.config.most_messages) close("too many messages");
  if (!closing_) {
    const auto bytes = heard_.cdata();
    user_->said(*this, {static_cast<const char*>(bytes.data()), bytes.size()}, stream_.got_binary());
  }
  explicit_bzero(heard_.data().data(), heard_.size());  // it may have been a password
  heard_.clear();
  closing_ ? sayFarewell() : listen();
}

void Visit::put(Parcel parcel) {
  if (user_ == nullptr || closing_) return;
  outbox_.put(std::move(parcel));
  pump();
}

void Visit::pump() {
  if (leaving_ || closing_) return;
  leaving_ = outbox_.take();
  if (!leaving_) return;
  stream_.binary(leaving_->binary);
  const boost::asio::const_buffer bytes{leaving_->bytes->data(), leaving_->bytes->size()};
  stream_.async_write(bytes, [self = shared_from_this()](Error error, std::size_t) {
    self->leaving_.reset();
    if (!error) self->pump();  // of an error the reader hears, too
  });
}

void Visit::close(const std::string& why) {
  if (user_ == nullptr || std::exchange(closing_, true)) return;
  house_.say(name_ + " is shown out: " + why);
  farewell_ = why.substr(0, kLongestFarewell);
  // Beast 1.74 does not bear a farewell while it reads; without one the connection just ends.
  if (reading_) stream_.next_layer().close();
}

void Visit::sayFarewell() {
  const websocket::close_reason reason{websocket::close_code::policy_error, farewell_};
  stream_.async_close(reason, [self = shared_from_this()](Error) { self->end({}); });
}

void Visit::end(const std::string& why) {
  leave(why);
  stream_.next_layer().close();  // what is still being sent ends, too
}

void Visit::leave(const std::string& why) {
  ChannelUser* const user = std::exchange(user_, nullptr);
  if (user == nullptr) return;
  try {
    house_.say(name_ + " has left" + (why.empty() ? "" : ": " + why));
  } catch (...) {  // no memory for the words
  }
  user->closed(*this);
}

}  // namespace darwinop::web
