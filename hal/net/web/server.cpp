// Web server: accepts connections and runs their handlers.
#include "hal/net/web/server.hpp"

#include <unistd.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <utility>

#include "hal/net/listener.hpp"
#include "hal/net/web/http_session.hpp"
#include "hal/net/web/messages.hpp"

namespace darwinop::web {
namespace {

namespace asio = boost::asio;

/// Kernel send buffer in bytes: one picture and some messages, so that a slow peer does not get minutes-old data.
constexpr int kSendBuffer = 16384;
constexpr int kAcceptsAtOnce = 16;  // then open connections are served

}  // namespace

struct WebServer::Impl {
  Impl(const WebServerConfig& config, Log log)
      : shared{.config = config, .log = net::BoundedLog{std::move(log)}, .pages = {}, .endpoints = {}},
        listener{config.address, config.port},
        acceptor{context, ::dup(listener.descriptor())} {
    waitForConnection();
  }

  void waitForConnection() {
    acceptor.async_wait(asio::posix::stream_descriptor::wait_read, [this](const boost::system::error_code& error) {
      if (error) return;
      for (int i = 0; i < kAcceptsAtOnce; ++i) {
        auto accepted = listener.accept();
        if (!accepted) break;
        accept(std::move(*accepted));
      }
      waitForConnection();
    });
  }

  void accept(net::Listener::Accepted accepted) {
    const auto has = [&](const net::Network& network) { return network.has(accepted.address); };
    if (std::ranges::none_of(shared.config.allowed, has))
      return shared.logLine(accepted.name + " was refused: " + messages::kNotInAllowedNetwork);
    if (!shared.makeRoom())
      return shared.logLine(accepted.name + " was refused: " + std::to_string(shared.connections) +
                            messages::kConnectionsOpen);
    boost::system::error_code error;
    asio::ip::tcp::socket socket{context};
    const int own = ::dup(accepted.socket.descriptor());
    if (own < 0) return;
    if (socket.assign(asio::ip::tcp::v4(), own, error); error) {
      ::close(own);
      return;
    }
    socket.set_option(asio::socket_base::send_buffer_size{kSendBuffer}, error);  // best effort
    std::make_shared<HttpSession>(shared, std::move(socket), accepted.name)->start();
  }

  ServerContext shared;
  net::Listener listener;
  asio::io_context context{1};  // declared after `shared`: destroys the sessions first
  asio::executor_work_guard<asio::io_context::executor_type> guard{context.get_executor()};
  asio::posix::stream_descriptor acceptor;
};

WebServer::WebServer(const WebServerConfig& config, Log log) : impl_{std::make_unique<Impl>(config, std::move(log))} {}

WebServer::~WebServer() = default;

void WebServer::serve(const std::string& path, WebPage page) {
  impl_->shared.pages[path] = std::move(page);
}

void WebServer::channel(const std::string& path, const std::string& subprotocol, ChannelHandler& handler) {
  impl_->shared.endpoints[path] = {subprotocol, &handler};
}

void WebServer::poll(Nanos longest) {
  constexpr int kAtOnce = 64;
  impl_->shared.log.reportOmitted(std::chrono::steady_clock::now().time_since_epoch());
  // run_one_for() with no time left runs no handler at all.
  if (impl_->context.poll_one() == 0 && impl_->context.run_one_for(longest) == 0) return;
  for (int i = 0; i < kAtOnce && impl_->context.poll_one() > 0; ++i) {
  }
}

std::uint16_t WebServer::port() const {
  return impl_->listener.port();
}

}  // namespace darwinop::web
