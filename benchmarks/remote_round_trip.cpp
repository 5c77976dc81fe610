// A whole poll (accelerometer, gyroscope, picture, twenty positions and torques) and its reply over the loopback, one
// after the other; beside it the same number of bytes each way from a thread that does nothing but send them, which is
// what the network alone costs.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>
#include <vector>

#include "remote/protocol/request_writer.hpp"
#include "remote/server/server.hpp"

namespace {

using namespace darwinop;
using namespace darwinop::remote;

constexpr int kRounds = 20'000;
constexpr std::size_t kJpegBytes = 11'300;  // thesis of 2013: 320x240 at 65 %

struct StillRobot final : RobotPort {
  Sensors seen{};
  StillRobot() {
    for (JointSensors& joint : seen.joint) {
      joint.motion.received();
      joint.position = Rad{0.5};
      joint.load = 0.1;
    }
    seen.board.motion.received();
    seen.board.gyro.fill(RadPerSec{0});
    seen.board.accelerometer.fill(MeterPerSec2{0});
  }
  void begin(Beginning) override {}
  void obey(const Request&) override {}
  Sensors sensors() override { return seen; }
  std::string mustEnd() override { return {}; }
  void hold() noexcept override {}
};

struct StillPicture final : PictureSource {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(kJpegBytes, 7);
  JpegPicture newest() override { return {.sequence = 1, .jpeg = bytes}; }
};

Socket connectTo(std::uint16_t port) {
  Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  name.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0)
    throw std::runtime_error("cannot connect");
  const int on = 1;
  (void)setsockopt(socket.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return socket;
}

/// Waits for `bytes` of them. False: the other end has closed.
bool receiveAll(const Socket& socket, std::vector<std::uint8_t>& bytes) {
  return recv(socket.descriptor(), bytes.data(), bytes.size(), MSG_WAITALL) == static_cast<ssize_t>(bytes.size());
}

Request wholePoll() {
  Request poll;
  poll.accelerometer = poll.gyro = poll.camera = true;
  for (std::uint8_t joint = 0; joint < kJoints; ++joint) {
    (void)poll.positions.add(joint);
    (void)poll.torques.add(joint);
  }
  return poll;
}

/// In us, the shortest first.
std::vector<double> measure(const Socket& socket, std::span<const std::uint8_t> request, std::size_t reply_size) {
  std::vector<std::uint8_t> reply(reply_size);
  std::vector<double> us;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    (void)send(socket.descriptor(), request.data(), request.size(), MSG_NOSIGNAL);
    if (!receiveAll(socket, reply)) throw std::runtime_error("the reply ended early");
    us.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  std::ranges::sort(us);
  return us;
}

}  // namespace

int main() {
  RequestBuffer buffer;
  const std::span<const std::uint8_t> request = writeRequest(wholePoll(), buffer);
  const std::size_t reply_size = kReplyHead + 24 + 4 + kJpegBytes + 8 * kJoints + 1;

  StillRobot robot;
  const auto clock = [] { return Nanos{std::chrono::steady_clock::now().time_since_epoch()}; };
  Server server{
      {.port = 0, .pace = Nanos{0}}, robot, [] { return std::make_unique<StillPicture>(); }, clock, [](const auto&) {}};
  std::atomic<bool> stop{false};
  std::thread serving{[&] { server.run(stop); }};
  const std::vector<double> ours = measure(connectTo(server.port()), request, reply_size);
  stop = true;
  serving.join();

  Listener echo{0x7F000001, 0};
  std::thread echoing{[&] {
    std::optional<Listener::Caller> caller;
    while (!caller) caller = echo.next();
    std::vector<std::uint8_t> in(request.size());
    const std::vector<std::uint8_t> out(reply_size, 7);
    (void)fcntl(caller->socket.descriptor(), F_SETFL, 0);
    while (receiveAll(caller->socket, in))
      (void)send(caller->socket.descriptor(), out.data(), out.size(), MSG_NOSIGNAL);
  }};
  const std::vector<double> peer = measure(connectTo(echo.port()), request, reply_size);
  echoing.join();

  const auto print = [&](const char* name, double share) {
    const auto at = static_cast<std::size_t>(share * (kRounds - 1));
    std::printf("bench: remote_round_trip_%s ours=%.1f peer=%.1f ratio=%.3f unit=us\n", name, ours[at], peer[at],
                ours[at] / peer[at]);
  };
  print("p50", 0.5);
  print("p99", 0.99);
}
