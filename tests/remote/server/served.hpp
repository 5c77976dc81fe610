// Server with a scripted clock on a loopback port, and clients that read like those of 2013.
#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <functional>
#include <vector>

#include "fake_robot_port.hpp"
#include "remote/server/server.hpp"
#include "support/hex.hpp"

namespace darwinop::remote {

using ByteList = std::vector<std::uint8_t>;

struct Served {
  FakeRobotPort robot;
  std::vector<std::string> said;
  Nanos now{std::chrono::hours{1}};
  Server server;

  /// Port 0: any free port.
  explicit Served(Server::OpenPictures pictures = {}, ServerConfig config = unhurried(), std::uint16_t port = 0)
      : server{onPort(port, std::move(config)), robot, std::move(pictures), [this] { return now; },
               [this](const std::string& line) { said.push_back(line); }} {}

  /// Handles all pending events. Loopback delivers before send() returns.
  void poll(int times = 6) {
    for (int i = 0; i < times; ++i) server.poll(Nanos{0});
  }
  void pass(std::chrono::milliseconds time) {
    now += time;
    poll();
  }
  [[nodiscard]] bool hasSaid(const std::string& part) const {
    for (const std::string& line : said)
      if (line.find(part) != std::string::npos) return true;
    return false;
  }

  /// The clock stands still, so the rate limit would never recover.
  static ServerConfig unhurried() {
    ServerConfig config;
    config.pace = Nanos{0};
    return config;
  }

 private:
  static ServerConfig onPort(std::uint16_t port, ServerConfig config) {
    config.port = port;
    return config;
  }
};

/// Non-blocking client socket.
class TestClient {
 public:
  /// `segment`: maximum TCP segment size; 0: that of loopback.
  explicit TestClient(Served& served, int segment = 0) : served_{served}, socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
    if (segment > 0) (void)setsockopt(socket_.descriptor(), IPPROTO_TCP, TCP_MAXSEG, &segment, sizeof segment);
    sockaddr_in name{};
    name.sin_family = AF_INET;
    name.sin_port = htons(served.server.port());
    name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = connect(socket_.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) == 0;
    const int on = 1;  // TCP_NODELAY: a second small piece must not wait for the acknowledgement of the first
    (void)setsockopt(socket_.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    (void)fcntl(socket_.descriptor(), F_SETFL, O_NONBLOCK);
    served_.poll();
  }

  [[nodiscard]] bool connected() const { return connected_; }
  void send(const ByteList& bytes) {
    sendOnly(bytes);
    served_.poll();
  }
  /// Without letting the server handle it.
  void sendOnly(const ByteList& bytes) { (void)::send(socket_.descriptor(), bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  void send(const std::string& hex) { send(fromHex(hex)); }
  void close() {
    socket_.close();
    served_.poll();
  }
  /// Resets the connection.
  void reset() {
    const linger at_once{1, 0};
    (void)setsockopt(socket_.descriptor(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    close();
  }
  /// At most `most` of the available bytes.
  ByteList receive(std::size_t most = 65536) {
    ByteList bytes(most);
    const ssize_t count = recv(socket_.descriptor(), bytes.data(), most, 0);
    closed_ = count == 0 || (count < 0 && errno != EAGAIN);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }
  /// The server has ended the connection.
  [[nodiscard]] bool shownOut() {
    (void)receive();
    return closed_;
  }
  [[nodiscard]] std::string ask(const std::string& hex) {
    send(hex);
    return toHex(receive());
  }
  [[nodiscard]] int descriptor() const { return socket_.descriptor(); }

 private:
  Served& served_;
  net::Socket socket_;
  bool connected_ = false, closed_ = false;
};

/// Length of a reply according to its header, NUL included.
inline std::size_t statedSize(const ByteList& reply) {
  return (std::size_t{reply[1]} << 24 | std::size_t{reply[2]} << 16 | std::size_t{reply[3]} << 8 | reply[4]) + 1;
}

/// The client of 2013: waits for 5 bytes, takes all available ones, discards them if the first is not 'W', then reads
/// until at least the stated length has arrived. Empty: it would block.
inline ByteList readAsIn2013(TestClient& client) {
  ByteList got = client.receive();
  if (got.size() < 5 || got[0] != 'W') return {};
  while (got.size() + 1 < statedSize(got)) {
    const ByteList more = client.receive();
    if (more.empty()) return {};
    got.insert(got.end(), more.begin(), more.end());
  }
  return got;
}

/// The later client: single bytes until a 'W', then 4, then the stated length; the NUL is skipped next time.
inline ByteList readAsToday(TestClient& client) {
  ByteList got;
  do {
    got = client.receive(1);
    if (got.empty()) return {};
  } while (got[0] != 'W');
  while (got.size() < 5 || got.size() + 1 < statedSize(got)) {
    const std::size_t most = got.size() < 5 ? 5 - got.size() : statedSize(got) - 1 - got.size();
    const ByteList more = client.receive(most);
    if (more.empty()) return {};
    got.insert(got.end(), more.begin(), more.end());
  }
  return got;
}

}  // namespace darwinop::remote
