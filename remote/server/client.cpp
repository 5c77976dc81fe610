// Connection of one client: receive buffer, send buffer, and what has been logged about it.
#include "remote/server/client.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "remote/server/messages.hpp"

namespace darwinop::remote {
namespace {

/// TCP segment size towards the client, bytes; 0: unknown.
std::size_t segmentBytes(int descriptor) {
  int bytes = 0;
  socklen_t size = sizeof bytes;
  return getsockopt(descriptor, IPPROTO_TCP, TCP_MAXSEG, &bytes, &size) == 0 && bytes > 0
             ? static_cast<std::size_t>(bytes)
             : 0;
}

}  // namespace

bool Client::receive() {
  const std::span<std::uint8_t> room = reader_.room();
  const ssize_t count = ::recv(descriptor(), room.data(), room.size(), 0);
  if (count == 0) return ended(messages::kDisconnected);
  if (count < 0)
    return net::isTemporary(errno) || ended(std::string{"the connection was lost: "} + std::strerror(errno));
  reader_.filled(static_cast<std::size_t>(count));
  return true;
}

bool Client::reply(const Request& request, const Reply& reply) {
  writeReply(request, reply, out_);
  // Alone in the last segment, the NUL may arrive after its reply was read. A client of 2013 would take it for the
  // start of the next reply and hang. Without the NUL, both clients of 2013 work.
  const std::size_t segment = segmentBytes(descriptor());
  if (segment > 0 && out_.size() % segment == 1) out_.pop_back();
  sent_ = 0;
  return flush();
}

bool Client::flush() {
  while (hasUnsent()) {
    const ssize_t count = ::send(descriptor(), out_.data() + sent_, out_.size() - sent_, MSG_NOSIGNAL);
    if (count < 0)
      return net::isTemporary(errno) || ended(std::string{"the connection was lost: "} + std::strerror(errno));
    sent_ += static_cast<std::size_t>(count);
  }
  return true;
}

}  // namespace darwinop::remote
