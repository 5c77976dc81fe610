// WebSocket client for tests, written from RFC 6455 without Boost.Beast, so that server and test share no bug. Waiting
// for bytes, it calls a function of the test, usually Server::poll().
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "hal/net/socket.hpp"

namespace darwinop::web {

struct ReceivedMessage {
  int opcode = 0;  // 1 text, 2 binary, 8 close, 9 ping, 10 pong
  std::string bytes;
};

class WebClient {
 public:
  using Meanwhile = std::function<void()>;

  /// `receive_buffer`: size of the kernel's receive buffer in bytes; 0: the default.
  WebClient(std::uint16_t port, Meanwhile meanwhile, int receive_buffer = 0)
      : meanwhile_{std::move(meanwhile)}, socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    if (receive_buffer > 0)
      (void)setsockopt(socket_.descriptor(), SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    open_ = ::connect(socket_.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
    (void)fcntl(socket_.descriptor(), F_SETFL, O_NONBLOCK);
  }

  void raw(const std::string& bytes) {
    (void)::send(socket_.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    meanwhile_();
  }
  /// The whole response to an HTTP request that is not an upgrade.
  std::string ask(const std::string& request) {
    raw(request);
    while (waitForBytes()) {
    }
    return std::exchange(bytes_, {});
  }
  static std::string upgrade(const std::string& path, const std::string& subprotocol, const std::string& more = {},
                             const std::string& host = "127.0.0.1:5024") {
    return "GET " + path + " HTTP/1.1\r\nHost: " + host +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n" +
           (subprotocol.empty() ? "" : "Sec-WebSocket-Protocol: " + subprotocol + "\r\n") + more + "\r\n";
  }
  /// The status line of the response; "HTTP/1.1 101" means that the channel is open.
  std::string open(const std::string& path, const std::string& subprotocol, const std::string& more = {}) {
    raw(upgrade(path, subprotocol, more));
    while (bytes_.find("\r\n\r\n") == std::string::npos && waitForBytes()) {
    }
    const std::size_t end = bytes_.find("\r\n\r\n");
    head_ = bytes_.substr(0, end);
    bytes_.erase(0, end == std::string::npos ? end : end + 4);
    return head_.substr(0, head_.find("\r\n"));
  }
  [[nodiscard]] const std::string& head() const { return head_; }

  void send(const std::string& text, int opcode = 1) {
    std::string frame{static_cast<char>(0x80 | opcode)};
    const std::size_t size = text.size();
    frame += static_cast<char>(0x80 | (size < 126 ? size : 126));
    if (size >= 126) frame += {static_cast<char>(size >> 8), static_cast<char>(size & 0xFF)};
    constexpr std::array<char, 4> kMask{1, 2, 3, 4};
    frame.append(kMask.data(), kMask.size());
    for (std::size_t i = 0; i < size; ++i) frame += static_cast<char>(text[i] ^ kMask[i % 4]);
    raw(frame);
  }

  /// The next message; answers pings and close frames. Nullopt: the connection has ended, or nothing arrives for 10 s.
  std::optional<ReceivedMessage> receiveMessage() {
    for (;;) {
      if (auto message = next()) {
        if (message->opcode == 9) send(message->bytes, 10);
        if (message->opcode == 8) send(message->bytes, 8);
        if (message->opcode != 9) return message;
      } else if (!waitForBytes()) {
        return std::nullopt;
      }
    }
  }
  /// All bytes that have arrived and were not parsed.
  const std::string& pendingBytes() {
    (void)readSocket();
    return bytes_;
  }
  /// Discards messages until the connection ends. False: it does not end within 10 s.
  bool atEnd() {
    while (receiveMessage()) {
    }
    return !open_;
  }
  [[nodiscard]] bool connected() const { return open_; }
  void disconnect() { socket_.close(); }
  /// Half-closes, then resets the connection: leaves no port in TIME_WAIT.
  void breakOff() {
    (void)shutdown(socket_.descriptor(), SHUT_WR);
    meanwhile_();
    const linger at_once{1, 0};
    (void)setsockopt(socket_.descriptor(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    socket_.close();
  }

 private:
  std::optional<ReceivedMessage> next() {
    if (bytes_.size() < 2) return std::nullopt;
    const auto at = [this](std::size_t i) { return static_cast<std::uint8_t>(bytes_[i]); };
    std::size_t head = 2, size = at(1) & 0x7F;
    const std::size_t more = size == 126 ? 2 : size == 127 ? 8 : 0;
    if (bytes_.size() < head + more) return std::nullopt;
    if (more > 0) size = 0;
    for (std::size_t i = 0; i < more; ++i) size = size << 8 | at(head++);
    if (bytes_.size() < head + size) return std::nullopt;
    ReceivedMessage message{at(0) & 0x0F, bytes_.substr(head, size)};
    bytes_.erase(0, head + size);
    return message;
  }
  /// Waits for more bytes. False: the connection has ended or 10 s are over.
  bool waitForBytes() {
    const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds{10};
    while (open_ && std::chrono::steady_clock::now() < give_up) {
      if (readSocket()) return true;
      if (open_) meanwhile_();
    }
    return false;
  }
  bool readSocket() {
    std::array<char, 65536> piece;
    const ssize_t count = recv(socket_.descriptor(), piece.data(), piece.size(), 0);
    if (count > 0) bytes_.append(piece.data(), static_cast<std::size_t>(count));
    if (count == 0 || (count < 0 && errno != EAGAIN)) open_ = false;
    return count > 0;
  }

  Meanwhile meanwhile_;
  net::Socket socket_;
  std::string bytes_, head_;
  bool open_ = false;
};

}  // namespace darwinop::web
