// The door: open while a client may come in, closed while one is inside.
#include "remote/server/listener.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace darwinop::remote {
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

bool setOption(const Socket& socket, int level, int name) {
  const int on = 1;
  return setsockopt(socket.descriptor(), level, name, &on, sizeof on) == 0;
}

/// With fcntl: accept4 and SOCK_NONBLOCK are younger than some kernels that robots run.
bool neverWaits(const Socket& socket) {
  return fcntl(socket.descriptor(), F_SETFL, O_NONBLOCK) == 0 && fcntl(socket.descriptor(), F_SETFD, FD_CLOEXEC) == 0;
}

}  // namespace

Listener::Listener(Ipv4 address, std::uint16_t port) : address_{address}, port_{port} {
  place_ = bound();
  sockaddr_in name{};
  socklen_t size = sizeof name;
  if (getsockname(place_.descriptor(), reinterpret_cast<sockaddr*>(&name), &size) != 0) cannotListen(address, port);
  port_ = ntohs(name.sin_port);
  open();
}

Socket Listener::bound() const {
  Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port_);
  name.sin_addr.s_addr = htonl(address_);
  if (!socket.open() || !neverWaits(socket) || !setOption(socket, SOL_SOCKET, SO_REUSEADDR) ||
      bind(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0)
    cannotListen(address_, port_);
  return socket;
}

void Listener::open() {
  if (isOpen()) return;
  Socket door = bound();
  if (listen(door.descriptor(), kBacklog) != 0) cannotListen(address_, port_);
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

}  // namespace darwinop::remote
