// The server of remote control around a robot that does nothing and a picture that is given: what is left is the
// exchange of a whole poll (accelerometer, gyroscope, picture, twenty positions and torques).
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "remote/protocol/request_writer.hpp"
#include "remote/server/server.hpp"

namespace darwinop::bench {

struct StillRobot final : remote::RobotPort {
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
  void begin(remote::Beginning) override {}
  void obey(const remote::Request&) override {}
  Sensors sensors() override { return seen; }
  std::string mustEnd() override { return {}; }
  void hold() noexcept override {}
};

inline remote::Request wholePoll(bool with_picture = true) {
  remote::Request poll;
  poll.accelerometer = poll.gyro = true;
  poll.camera = with_picture;
  for (std::uint8_t joint = 0; joint < kJoints; ++joint) {
    (void)poll.positions.add(joint);
    (void)poll.torques.add(joint);
  }
  return poll;
}

inline net::Socket connectTo(std::uint16_t port, net::Ipv4 address = INADDR_LOOPBACK) {
  net::Socket socket{::socket(AF_INET, SOCK_STREAM, 0)};
  sockaddr_in name{};
  name.sin_family = AF_INET;
  name.sin_port = htons(port);
  name.sin_addr.s_addr = htonl(address);
  if (connect(socket.descriptor(), reinterpret_cast<const sockaddr*>(&name), sizeof name) != 0)
    throw std::runtime_error("cannot connect");
  const int on = 1;
  (void)setsockopt(socket.descriptor(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return socket;
}

/// Waits for `bytes` of them. False: the other end has closed.
inline bool receiveAll(const net::Socket& socket, std::vector<std::uint8_t>& bytes) {
  return recv(socket.descriptor(), bytes.data(), bytes.size(), MSG_WAITALL) == static_cast<ssize_t>(bytes.size());
}

/// The server in a thread of its own.
class ServingThread {
 public:
  /// `prepare` is called in the thread, before the server listens.
  explicit ServingThread(remote::ServerConfig config = anyPort(), const std::function<void()>& prepare = {})
      : thread_{[this, config, prepare] {
          if (prepare) prepare();
          const auto clock = [] { return Nanos{std::chrono::steady_clock::now().time_since_epoch()}; };
          const auto open = [this] { return std::make_unique<Shown>(*this); };
          remote::Server server{config, robot_, open, clock, [](const auto&) {}};
          port_ = server.port();
          server.run(stop_);
        }} {
    while (port_ == 0) std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  ~ServingThread() {
    stop_ = true;
    thread_.join();
  }
  ServingThread(const ServingThread&) = delete;
  ServingThread& operator=(const ServingThread&) = delete;

  /// No limit: what is measured here comes one after the other, without a pause.
  static remote::ServerConfig anyPort() {
    remote::ServerConfig config;
    config.port = 0;
    config.pace = Nanos{0};
    return config;
  }
  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// Between two exchanges only.
  void show(std::vector<std::uint8_t> jpeg) {
    const std::lock_guard lock{mutex_};
    jpeg_ = std::move(jpeg);
  }

 private:
  struct Shown final : remote::PictureSource {
    explicit Shown(ServingThread& owner) : owner_{owner} {}
    remote::JpegPicture newest() override {
      const std::lock_guard lock{owner_.mutex_};
      return {.sequence = 1, .jpeg = owner_.jpeg_};
    }
    ServingThread& owner_;
  };

  StillRobot robot_;
  std::mutex mutex_;
  std::vector<std::uint8_t> jpeg_;
  std::atomic<std::uint16_t> port_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// Asks for everything and waits for it.
class PollingClient {
 public:
  explicit PollingClient(net::Socket socket) : socket_{std::move(socket)} {}

  /// In us. `picture`: bytes of it, 0: none is asked for. A reply has one byte less when its NUL would travel alone.
  double exchange(std::size_t picture) {
    const auto request = remote::writeRequest(wholePoll(picture > 0), buffer_);
    const auto start = std::chrono::steady_clock::now();
    (void)send(socket_.descriptor(), request.data(), request.size(), MSG_NOSIGNAL);
    // As today's client reads: without the NUL, which heads the next reply.
    reply_.resize(remote::kReplyHead + 24 + (picture > 0 ? 4 + picture : 0) + 8 * kJoints);
    std::uint8_t first = 0;
    while (first != 'W')
      if (recv(socket_.descriptor(), &first, 1, 0) != 1) throw std::runtime_error("the reply ended early");
    reply_.pop_back();
    if (!receiveAll(socket_, reply_)) throw std::runtime_error("the reply ended early");
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
  }

 private:
  net::Socket socket_;
  remote::RequestBuffer buffer_{};
  std::vector<std::uint8_t> reply_;
};

}  // namespace darwinop::bench
