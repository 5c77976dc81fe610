// A server that answers as a test says, in a thread of its own, on a loopback port of its own.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "hal/net/socket.hpp"
#include "remote/protocol/reply.hpp"
#include "remote/protocol/request_reader.hpp"

namespace darwinop::remote {

/// How a reply is to be sent.
struct Answer {
  std::vector<std::uint8_t> bytes;
  std::size_t cut_at = SIZE_MAX;  // so many bytes, then the connection ends
  bool trickles = false;          // every byte on its own
};

class ScriptedServer {
 public:
  /// `request`, and the number of the connection that it came on, from 0.
  using Script = std::function<Answer(const Request& request, int connection)>;

  explicit ScriptedServer(Script script, std::uint16_t port = 0)
      : script_{std::move(script)}, door_{::socket(AF_INET, SOCK_STREAM, 0)} {
    const int on = 1;
    (void)setsockopt(door_.descriptor(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port);
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    (void)bind(door_.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name);
    (void)listen(door_.descriptor(), 4);
    socklen_t size = sizeof name;
    (void)getsockname(door_.descriptor(), reinterpret_cast<sockaddr*>(&name), &size);
    port_ = ntohs(name.sin_port);
    thread_ = std::thread{[this] { run(); }};
  }
  ~ScriptedServer() {
    stop_ = true;
    thread_.join();
  }
  ScriptedServer(const ScriptedServer&) = delete;
  ScriptedServer& operator=(const ScriptedServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::vector<Request> requests() const {
    const std::lock_guard lock{mutex_};
    return requests_;
  }

 private:
  [[nodiscard]] bool ready(const net::Socket& socket) const {
    pollfd place{socket.descriptor(), POLLIN, 0};
    while (!stop_)
      if (poll(&place, 1, 20) > 0) return true;
    return false;
  }
  void run() {
    for (int connection = 0; ready(door_); ++connection)
      serve(net::Socket{accept(door_.descriptor(), nullptr, nullptr)}, connection);
  }
  void serve(const net::Socket& client, int connection) {
    RequestReader reader;
    while (ready(client)) {
      const std::span<std::uint8_t> room = reader.room();
      const ssize_t count = recv(client.descriptor(), room.data(), room.size(), 0);
      if (count <= 0) return;
      reader.filled(static_cast<std::size_t>(count));
      Request request;
      Oddities oddities;
      while (reader.next(request, oddities) == RequestReader::Found::kRequest) {
        {
          const std::lock_guard lock{mutex_};
          requests_.push_back(request);
        }
        if (!send(client, script_(request, connection))) return;
      }
    }
  }
  static bool send(const net::Socket& client, const Answer& answer) {
    const std::size_t size = std::min(answer.bytes.size(), answer.cut_at), piece = answer.trickles ? 1 : size;
    for (std::size_t at = 0; at < size; at += piece)
      (void)::send(client.descriptor(), answer.bytes.data() + at, std::min(piece, size - at), MSG_NOSIGNAL);
    return answer.cut_at == SIZE_MAX;
  }

  Script script_;
  net::Socket door_;
  std::uint16_t port_ = 0;
  std::atomic<bool> stop_{false};
  mutable std::mutex mutex_;
  std::vector<Request> requests_;
  std::thread thread_;
};

}  // namespace darwinop::remote
