// The door: open while a client may come in, closed while one is inside.
#include "hal/net/listener.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace darwinop::net {
namespace {

constexpr int kBacklog = 4;

[[noreturn]] void cannotListen(Ipv4 address, std::uint16_t port) {
  const int error = errno;
  const std::string place = textFromIpv4(address) + ":" + std::to_string(port);
  const char* const remedy = error == EADDRINUSE      ? "; another server runs there: end it, or choose another --port"
                             : error == EADDRNOTAVAIL ? "; give an address of this computer with --listen"
                             : error == EACCES        ? "; ports under 1024 belong to root: choose another --port"
                                                      : "";
  throw std::runtime_error("cannot listen on " + place + ": " + std::strerror(error) + remedy);
}

bool setOption(const Socket& socket, int level, int name, bool value = true) {
  const int on = value ? 1 : 0;
  return setsockopt(socket.descriptor(), level, name, &on, sizeof on) == 0;
}

/// With fcntl: accept4 and SOCK_NONBLOCK are younger than some kernels that robots run.
bool neverWaits(const Socket& socket) {
  return fcntl(socket.descriptor(), F_SETFL, O_NONBLOCK) == 0 && fcntl(socket.descriptor(), F_SETFD, FD_CLOEXEC) == 0;
}

}  // namespace

Listener::Listener(Ipv4 address, std::uint16_t port) : address_{address}, port_{port} {
  place_ = made();
  bindToPort(place_);
  sockaddr_in name{};
  socklen_t size = sizeof name;
  if (getsockname(place_.descriptor(), reinterpret_cast<sockaddr*>(&name), &size) != 0) cannotListen(address, port);
  port_ = ntohs(name.sin_port);
  // After bind(): a second server of the same user is refused. Linux 3.9 and later.
  shares_by_user_ = setOption(place_, SOL_SOCKET, SO_REUSEPORT);
  open();
}

Socket Listener::made() const {
  Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
  // SO_REUSEADDR: connections that have just ended hold the port for a minute, and connections inherit it from door_.
  if (!socket.open() || !neverWaits(socket) || !setOption(socket, SOL_SOCKET, SO_REUSEADDR))
    cannotListen(address_, port_);
  return socket;
}

void Listener::bindToPort(const Socket& socket) const {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port_);
  name.sin_addr.s_addr = htonl(address_);
  if (bind(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0)
    cannotListen(address_, port_);
}

/// Two sockets with SO_REUSEADDR of which none listens may be bound to one port, whoever's they are. So place_ has it
/// only while it is bound itself. door_ is bound beside it by SO_REUSEPORT, which the kernel grants to sockets of one
/// user. Older kernels need SO_REUSEADDR on place_ until door_ listens: microseconds, in which others may be bound,
/// too.
void Listener::open() {
  if (isOpen()) return;
  Socket door = made();
  if (!setOption(place_, SOL_SOCKET, SO_REUSEADDR, !shares_by_user_) ||
      (shares_by_user_ && !setOption(door, SOL_SOCKET, SO_REUSEPORT)))
    cannotListen(address_, port_);
  bindToPort(door);
  if (listen(door.descriptor(), kBacklog) != 0 || !setOption(place_, SOL_SOCKET, SO_REUSEADDR, false))
    cannotListen(address_, port_);
  door_ = std::move(door);
}

std::optional<Listener::Caller> Listener::next() {
  sockaddr_in name{};
  socklen_t size = sizeof name;
  Socket socket{accept(door_.descriptor(), reinterpret_cast<sockaddr*>(&name), &size)};
  if (!socket.open() || !neverWaits(socket)) return std::nullopt;
  (void)setOption(socket, IPPROTO_TCP, TCP_NODELAY);
  const Ipv4 address = ntohl(name.sin_addr.s_addr);
  return Caller{std::move(socket), address, textFromIpv4(address) + ":" + std::to_string(ntohs(name.sin_port))};
}

}  // namespace darwinop::net
