// The HTTP request of one connection, with Boost.Beast.
#include "hal/net/web/http_session.hpp"

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <utility>

#include "hal/net/web/messages.hpp"

namespace darwinop::web {
namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;
namespace websocket = boost::beast::websocket;

constexpr std::uint32_t kLongestHead = 8192;

std::string_view viewOf(beast::string_view text) {
  return {text.data(), text.size()};
}

/// Whether a comma-separated header value has this item.
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

void ServerContext::logLine(const std::string& line) {
  log.line(line, std::chrono::steady_clock::now().time_since_epoch());
}

bool ServerContext::makeRoom() {
  if (connections < config.max_connections) return true;
  if (idle_sessions.empty()) return false;
  idle_sessions.front()->evict();
  return true;
}

HttpSession::HttpSession(ServerContext& shared, boost::asio::ip::tcp::socket socket, std::string name)
    : context_{shared},
      name_{std::move(name)},
      stream_{std::move(socket)},
      read_buffer_{shared.config.max_message_bytes + kLongestHead} {
  ++context_.connections;
  context_.idle_sessions.push_back(this);
}

HttpSession::~HttpSession() {
  notifyClosed({});
  if (is_channel_) --context_.channels;
  if (is_counted_) --context_.connections;
  context_.idle_sessions.remove(this);
}

void HttpSession::evict() {
  context_.logLine(name_ + messages::kClosedForNewer + "; it had " + (request_->is_done() ? "" : "not ") +
                   "sent its request");
  context_.idle_sessions.remove(this);
  --context_.connections;
  is_counted_ = false;
  stream_.next_layer().close();
}

void HttpSession::start() {
  request_.emplace();
  request_->header_limit(kLongestHead);
  request_->body_limit(0);
  stream_.next_layer().expires_after(context_.config.handshake_timeout);
  http::async_read(stream_.next_layer(), read_buffer_, *request_,
                   [self = shared_from_this()](Error error, std::size_t) {
                     error ? self->answerUnreadable(error) : self->respond();
                   });
}

/// A connection that ended or was too slow gets no answer.
void HttpSession::answerUnreadable(Error error) {
  if (error == http::error::end_of_stream || error == http::error::partial_message) return;
  if (error == http::error::body_limit) return refuse(Status::payload_too_large, "a request here has no body");
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return refuse(Status::request_header_fields_too_large,
                  "the head of a request has at most " + std::to_string(kLongestHead) + " bytes");
  if (error.category() == make_error_code(http::error::bad_method).category())
    refuse(Status::bad_request, "this is not an HTTP request; is the address https:// instead of http://?");
}

void HttpSession::respond() {
  const auto& request = request_->get();
  RequestOrigin request_origin{.host = viewOf(request[http::field::host]), .origin = {}};
  if (const auto origin = request.find(http::field::origin); origin != request.end())
    request_origin.origin = viewOf(origin->value());
  if (request.count(http::field::host) != 1 || request.count(http::field::origin) > 1)
    return refuse(Status::bad_request, "a request needs exactly one Host and at most one Origin header");
  if (const std::string why = refusal(context_.config.origin, request_origin); !why.empty())
    return refuse(Status::forbidden, why);

  const std::string_view path = viewOf(request.target()).substr(0, request.target().find('?'));
  const auto endpoint = context_.endpoints.find(path);
  if (websocket::is_upgrade(request)) {
    if (endpoint == context_.endpoints.end())
      return refuse(Status::not_found, "there is no WebSocket endpoint at this path");
    return upgrade(endpoint->second);
  }
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return refuse(Status::method_not_allowed, "GET and HEAD only");
  if (endpoint != context_.endpoints.end())
    return refuse(Status::upgrade_required,
                  "this path is a WebSocket endpoint; use the subprotocol " + endpoint->second.subprotocol);
  const auto page = context_.pages.find(path);
  if (page == context_.pages.end()) return refuse(Status::not_found, "there is no page at this path");
  reply(Status::ok, page->second, request.method() == http::verb::get);
}

void HttpSession::refuse(Status status, const std::string& why) {
  context_.logLine(name_ + " was refused: " + why);
  reply(status, {"text/plain; charset=utf-8", why + "\n"}, request_->get().method() != http::verb::head);
}

void HttpSession::reply(Status status, WebPage page, bool body) {
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
  stream_.next_layer().expires_after(context_.config.idle_timeout);
  http::async_write(stream_.next_layer(), reply_, [self = shared_from_this()](Error, std::size_t) {
    Error ignored;
    self->stream_.next_layer().socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  });
}

void HttpSession::upgrade(const Endpoint& endpoint) {
  const auto& request = request_->get();
  if (!listHas(viewOf(request[http::field::sec_websocket_protocol]), endpoint.subprotocol))
    return refuse(Status::bad_request, "offer the subprotocol " + endpoint.subprotocol);
  if (context_.channels >= context_.config.max_channels)
    return refuse(Status::service_unavailable, "all " + std::to_string(context_.channels) +
                                                   " WebSocket connections are in use; close one and try again");
  ++context_.channels;
  is_channel_ = true;
  context_.idle_sessions.remove(this);
  stream_.next_layer().expires_never();  // the WebSocket has its own timeouts
  websocket::stream_base::timeout times{};
  times.handshake_timeout = context_.config.handshake_timeout;
  times.idle_timeout = context_.config.idle_timeout;
  times.keep_alive_pings = true;
  stream_.set_option(times);
  stream_.set_option(
      websocket::stream_base::decorator([name = endpoint.subprotocol](websocket::response_type& response) {
        response.set(http::field::sec_websocket_protocol, name);
        response.erase(http::field::server);
      }));
  stream_.read_message_max(context_.config.max_message_bytes);
  stream_.auto_fragment(false);
  stream_.async_accept(request, [self = shared_from_this(), &endpoint](Error error) {
    if (!error) self->opened(endpoint);
  });
}

}  // namespace darwinop::web
