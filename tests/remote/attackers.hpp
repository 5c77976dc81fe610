// Clients that mean no good, on this computer's loopback: what they can send at most, until they are stopped.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <thread>
#include <vector>

#include "hal/net/socket.hpp"
#include "remote/protocol/request.hpp"

namespace darwinop::remote {

enum class Attack : std::uint8_t {
  kConnects,   // comes and goes
  kGarbage,    // bytes that are no request
  kRequests,   // requests without end, replies are fetched
  kDeaf,       // requests for all there is, replies are not fetched
  kSlowLoris,  // sixty-four connections, a byte of a request a second on each
};
inline constexpr std::array kAttacks{Attack::kConnects, Attack::kGarbage, Attack::kRequests, Attack::kDeaf,
                                     Attack::kSlowLoris};

inline const char* nameOf(Attack attack) {
  constexpr std::array kNames{"connects", "garbage", "requests", "deaf", "slow_loris"};
  return kNames[static_cast<std::size_t>(attack)];
}

/// In a thread of its own, from the beginning to the end of its life.
class Attacker {
 public:
  /// `prepare` is called in the thread, first.
  Attacker(Attack attack, std::uint16_t port, const std::function<void()>& prepare = {})
      : port_{port}, thread_{[this, attack, prepare] {
          if (prepare) prepare();
          run(attack);
        }} {}
  ~Attacker() {
    stop_ = true;
    thread_.join();
  }
  Attacker(const Attacker&) = delete;
  Attacker& operator=(const Attacker&) = delete;

  /// Connections that the server's computer took.
  [[nodiscard]] std::uint64_t connected() const { return connected_; }
  [[nodiscard]] std::uint64_t sent() const { return sent_; }  // bytes

 private:
  using Bytes = std::vector<std::uint8_t>;

  void run(Attack attack) {
    if (attack == Attack::kConnects) return comeAndGo();
    if (attack == Attack::kSlowLoris) return trickle();
    Bytes bytes;
    if (attack == Attack::kGarbage) bytes.assign(65536, 'x');
    static constexpr std::array<std::uint8_t, 4> kNothing{'W', 4, 0, 0};
    static constexpr std::array<std::uint8_t, 9> kMuch{'W', 9, 0, 'A', 'G', 'C', 'P', 1, 0};
    const std::span<const std::uint8_t> request =
        attack == Attack::kRequests ? std::span<const std::uint8_t>{kNothing} : std::span<const std::uint8_t>{kMuch};
    while (bytes.size() < 65536) bytes.insert(bytes.end(), request.begin(), request.end());
    while (!stop_) pour(bytes, attack != Attack::kDeaf);
  }

  /// A socket that never waits, and leaves nothing behind when it closes.
  [[nodiscard]] net::Socket reach() {
    net::Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
    const linger at_once{1, 0};
    (void)setsockopt(socket.descriptor(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(port_);
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    (void)fcntl(socket.descriptor(), F_SETFL, O_NONBLOCK);
    (void)connect(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name);
    pollfd place{socket.descriptor(), POLLOUT, 0};
    if (poll(&place, 1, 20) == 1 && (place.revents & (POLLERR | POLLHUP)) == 0)
      ++connected_;
    else
      socket.close();
    return socket;
  }

  void comeAndGo() {
    while (!stop_) (void)reach();
  }

  /// One connection, for as long as it lasts.
  void pour(const Bytes& bytes, bool reads) {
    const net::Socket socket = reach();
    if (!socket.open()) return;
    Bytes replies(65536);
    std::size_t at = 0;
    while (!stop_) {
      pollfd place{socket.descriptor(), static_cast<short>(reads ? POLLIN | POLLOUT : POLLOUT), 0};
      if (poll(&place, 1, 20) == 0) continue;
      if ((place.revents & (POLLERR | POLLHUP)) != 0) return;
      if ((place.revents & POLLIN) != 0 && recv(socket.descriptor(), replies.data(), replies.size(), 0) == 0) return;
      if ((place.revents & POLLOUT) == 0) continue;
      const ssize_t count = send(socket.descriptor(), bytes.data() + at, bytes.size() - at, MSG_NOSIGNAL);
      if (count <= 0) continue;
      sent_ += static_cast<std::uint64_t>(count);
      at = (at + static_cast<std::size_t>(count)) % bytes.size();
    }
  }

  void trickle() {
    constexpr std::array<std::uint8_t, 6> kBegin{'W', 0x2f, 0, 'A', 'G', 'C'};
    std::vector<net::Socket> sockets(64);
    for (std::size_t tick = 0; !stop_; ++tick) {  // of 10 ms; whoever is out tries to come in
      const std::uint8_t byte = kBegin[tick / 100 % kBegin.size()];
      for (net::Socket& socket : sockets) {
        if (!socket.open()) socket = reach();
        if (!socket.open() || tick % 100 != 0) continue;
        if (send(socket.descriptor(), &byte, 1, MSG_NOSIGNAL) == 1)
          ++sent_;
        else
          socket.close();
      }
      std::this_thread::sleep_for(std::chrono::milliseconds{10});
    }
  }

  std::uint16_t port_;
  std::atomic<bool> stop_{false};
  std::atomic<std::uint64_t> connected_{0}, sent_{0};
  std::thread thread_;
};

}  // namespace darwinop::remote
