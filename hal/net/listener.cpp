// Listening TCP socket that can be closed and reopened without giving up its port.
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

[[noreturn]] void throwCannotListen(Ipv4 address, std::uint16_t port) {
  const int error = errno;
  const std::string endpoint = textFromIpv4(address) + ":" + std::to_string(port);
  const char* const remedy = error == EADDRINUSE ? "; another server uses the port: end it, or choose another --port"
                             : error == EADDRNOTAVAIL ? "; give an address of this computer with --listen"
                             : error == EACCES ? "; ports below 1024 are reserved for root: choose another --port"
                                               : "";
  throw std::runtime_error(kCannotListen + endpoint + ": " + std::strerror(error) + remedy);
}

bool setOption(const Socket& socket, int level, int name, bool value = true) {
  const int on = value ? 1 : 0;
  return setsockopt(socket.descriptor(), level, name, &on, sizeof on) == 0;
}

/// With fcntl, because some robots run kernels without accept4 and SOCK_NONBLOCK.
bool setNonBlocking(const Socket& socket) {
  return fcntl(socket.descriptor(), F_SETFL, O_NONBLOCK) == 0 && fcntl(socket.descriptor(), F_SETFD, FD_CLOEXEC) == 0;
}

}  // namespace

Listener::Listener(Ipv4 address, std::uint16_t port) : address_{address}, port_{port} {
  reservation_ = makeSocket();
  bindToPort(reservation_);
  sockaddr_in name{};
  socklen_t size = sizeof name;
  if (getsockname(reservation_.descriptor(), reinterpret_cast<sockaddr*>(&name), &size) != 0)
    throwCannotListen(address, port);
  port_ = ntohs(name.sin_port);
  // After bind(): a second server of the same user is refused. Linux 3.9 and later.
  shares_by_user_ = setOption(reservation_, SOL_SOCKET, SO_REUSEPORT);
  open();
}

Socket Listener::makeSocket() const {
  Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
  // SO_REUSEADDR: without it, connections in TIME_WAIT block the port for a minute. Accepted sockets inherit it.
  if (!socket.open() || !setNonBlocking(socket) || !setOption(socket, SOL_SOCKET, SO_REUSEADDR))
    throwCannotListen(address_, port_);
  return socket;
}

void Listener::bindToPort(const Socket& socket) const {
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port_);
  name.sin_addr.s_addr = htonl(address_);
  if (bind(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0)
    throwCannotListen(address_, port_);
}

/// Keeps other users off the port. The kernel lets any two sockets with SO_REUSEADDR bind to one port while neither
/// listens, so reservation_ has the option only while it binds. listening_ is bound beside it with SO_REUSEPORT, which
/// the kernel grants to sockets of one user only. Kernels before 3.9 need SO_REUSEADDR on reservation_ until listening_
/// listens: for some microseconds another user's socket may bind as well.
void Listener::open() {
  if (isOpen()) return;
  Socket socket = makeSocket();
  if (!setOption(reservation_, SOL_SOCKET, SO_REUSEADDR, !shares_by_user_) ||
      (shares_by_user_ && !setOption(socket, SOL_SOCKET, SO_REUSEPORT)))
    throwCannotListen(address_, port_);
  bindToPort(socket);
  if (listen(socket.descriptor(), kBacklog) != 0 || !setOption(reservation_, SOL_SOCKET, SO_REUSEADDR, false))
    throwCannotListen(address_, port_);
  listening_ = std::move(socket);
}

std::optional<Listener::Accepted> Listener::accept() {
  sockaddr_in name{};
  socklen_t size = sizeof name;
  Socket socket{::accept(listening_.descriptor(), reinterpret_cast<sockaddr*>(&name), &size)};
  if (!socket.open() || !setNonBlocking(socket)) return std::nullopt;
  (void)setOption(socket, IPPROTO_TCP, TCP_NODELAY);
  const Ipv4 address = ntohl(name.sin_addr.s_addr);
  return Accepted{std::move(socket), address, textFromIpv4(address) + ":" + std::to_string(ntohs(name.sin_port))};
}

}  // namespace darwinop::net
