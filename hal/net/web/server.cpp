#include "hal/net/web/server.hpp"

#include <unistd.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <utility>

#include "hal/net/listener.hpp"
#include "hal/net/web/visit.hpp"

namespace darwinop::web {
namespace {

namespace asio = boost::asio;

/// What a slow peer's kernel may hold of ours: a picture and some messages, not minutes of them.
constexpr int kSendBuffer = 16384;
constexpr int kGuestsAtOnce = 16;  // then others have their turn

}  // namespace

struct Server::Work {
  Work(const ServerConfig& config, Say say)
      : house{.config = config, .log = net::BoundedLog{std::move(say)}, .pages = {}, .endpoints = {}},
        listener{config.address, config.port},
        door{context, ::dup(listener.descriptor())} {
    waitAtDoor();
  }

  void waitAtDoor() {
    door.async_wait(asio::posix::stream_descriptor::wait_read, [this](const boost::system::error_code& error) {
      if (error) return;
      for (int i = 0; i < kGuestsAtOnce; ++i) {
        auto caller = listener.next();
        if (!caller) break;
        letIn(std::move(*caller));
      }
      waitAtDoor();
    });
  }

  void letIn(net::Listener::Caller caller) {
    const auto has = [&](const net::Network& network) { return network.has(caller.address); };
    if (std::ranges::none_of(house.config.allowed, has))
      return house.say(caller.name + " may not come in; --allow names who may");
    if (!house.makeRoom())
      return house.say(caller.name + " has to go: there are " + std::to_string(house.connections) + " connections");
    boost::system::error_code error;
    asio::ip::tcp::socket socket{context};
    const int own = ::dup(caller.socket.descriptor());
    if (own < 0) return;
    if (socket.assign(asio::ip::tcp::v4(), own, error); error) {
      ::close(own);
      return;
    }
    socket.set_option(asio::socket_base::send_buffer_size{kSendBuffer}, error);  // a wish
    std::make_shared<Visit>(house, std::move(socket), caller.name)->begin();
  }

  House house;
  net::Listener listener;
  asio::io_context context{1};  // behind the house: visits end with it
  asio::executor_work_guard<asio::io_context::executor_type> guard{context.get_executor()};
  asio::posix::stream_descriptor door;
};

Server::Server(const ServerConfig& config, Say say) : work_{std::make_unique<Work>(config, std::move(say))} {}

Server::~Server() = default;

void Server::serve(const std::string& path, Page page) {
  work_->house.pages[path] = std::move(page);
}

void Server::channel(const std::string& path, const std::string& subprotocol, ChannelUser& user) {
  work_->house.endpoints[path] = {subprotocol, &user};
}

void Server::attend(Nanos longest) {
  constexpr int kAtOnce = 64;
  work_->house.log.look(std::chrono::steady_clock::now().time_since_epoch());
  // With no time to wait run_one_for() would not even look.
  if (work_->context.poll_one() == 0 && work_->context.run_one_for(longest) == 0) return;
  for (int i = 0; i < kAtOnce && work_->context.poll_one() > 0; ++i) {
  }
}

std::uint16_t Server::port() const {
  return work_->listener.port();
}

}  // namespace darwinop::web
