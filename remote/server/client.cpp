// One connection: what came, what has still to go out, what was already said about it.
#include "remote/server/client.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <cstring>

namespace darwinop::remote {
namespace {

bool comesLater(int error) {
  return error == EAGAIN || error == EWOULDBLOCK || error == EINTR;
}

}  // namespace

bool Client::receive() {
  const std::span<std::uint8_t> room = reader_.room();
  const ssize_t count = ::recv(descriptor(), room.data(), room.size(), 0);
  if (count == 0) return ended("has left");
  if (count < 0) return comesLater(errno) || ended(std::string{"the connection was lost: "} + std::strerror(errno));
  reader_.filled(static_cast<std::size_t>(count));
  return true;
}

bool Client::reply(const Request& request, const Reply& reply) {
  writeReply(request, reply, out_);
  sent_ = 0;
  return flush();
}

bool Client::flush() {
  while (owes()) {
    const ssize_t count = ::send(descriptor(), out_.data() + sent_, out_.size() - sent_, MSG_NOSIGNAL);
    if (count < 0) return comesLater(errno) || ended(std::string{"the connection was lost: "} + std::strerror(errno));
    sent_ += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace darwinop::remote
