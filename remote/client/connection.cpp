// Client connection: one request and one reply at a time, with bounded waits.
#include "remote/client/connection.hpp"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>

#include "remote/client/messages.hpp"

namespace darwinop::remote {

void Connection::connect(std::uint32_t address, std::uint16_t port) {
  close("");
  socket_ = net::Socket{::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
  if (!socket_.open()) return close(std::strerror(errno));
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  name.sin_addr.s_addr = htonl(address);
  const int on = 1;
  (void)setsockopt(socket_.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  state_ = State::kConnecting;
  if (::connect(socket_.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0)
    state_ = State::kOpen;
  else if (errno != EINPROGRESS)
    close(std::strerror(errno));
}

void Connection::close(const std::string& why) {
  socket_.close();
  state_ = State::kClosed;
  why_ = why;
  out_ = {};
  reader_.forget();
  asked_.reset();
}

void Connection::send(const Request& request) {
  asked_ = request;
  out_ = writeRequest(request, buffer_);
  flush();
}

bool Connection::wait(Nanos longest) {
  const bool sending = state_ == State::kConnecting || !out_.empty();
  pollfd place{socket_.descriptor(), static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0};
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(longest);
  const timespec time{static_cast<time_t>(whole.count()), static_cast<long>((longest - whole).count())};
  const int ready = ppoll(&place, state_ == State::kClosed ? 0 : 1, &time, nullptr);
  if (ready < 0) return errno != EINTR;
  if (ready > 0) handle(place.revents);
  return true;
}

void Connection::handle(short events) {
  if (state_ == State::kConnecting) {
    int error = 0;
    socklen_t size = sizeof error;
    (void)getsockopt(socket_.descriptor(), SOL_SOCKET, SO_ERROR, &error, &size);
    if (error != 0) return close(std::strerror(error));
    state_ = State::kOpen;
    return;
  }
  if ((events & POLLOUT) != 0) flush();
  if (state_ == State::kOpen && (events & (POLLIN | POLLERR | POLLHUP)) != 0) receive();
}

void Connection::flush() {
  while (!out_.empty()) {
    const ssize_t count = ::send(socket_.descriptor(), out_.data(), out_.size(), MSG_NOSIGNAL);
    if (count < 0) {
      if (!net::isTemporary(errno)) close(std::strerror(errno));
      return;
    }
    out_ = out_.subspan(static_cast<std::size_t>(count));
  }
}

void Connection::receive() {
  const std::span<std::uint8_t> room = reader_.room();
  if (room.empty()) return;
  const ssize_t count = ::recv(socket_.descriptor(), room.data(), room.size(), 0);
  if (count > 0) {
    reader_.filled(static_cast<std::size_t>(count));
    if (!asked_) reader_.forget();  // the NUL after a reply, or unrequested bytes
    return;
  }
  if (count == 0) return close("the server has closed the connection");
  if (!net::isTemporary(errno)) close(std::strerror(errno));
}

std::optional<Reply> Connection::reply() {
  if (!asked_) return std::nullopt;
  Reply reply;
  switch (reader_.next(*asked_, reply)) {
    case ReplyReader::Result::kIncomplete:
      return std::nullopt;
    case ReplyReader::Result::kInvalid:
      close(messages::kInvalidReply);
      return std::nullopt;
    case ReplyReader::Result::kReply:
      break;
  }
  asked_.reset();
  return reply;
}

}  // namespace darwinop::remote
