// TCP server of remote control: single-threaded, one client at a time, never blocks on robot, encoder or network.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hal/byte_line.hpp"
#include "hal/net/addresses.hpp"
#include "hal/net/bounded_log.hpp"
#include "hal/net/listener.hpp"
#include "hal/net/rate_limiter.hpp"
#include "remote/picture_source.hpp"
#include "remote/server/client.hpp"
#include "remote/server/robot_port.hpp"

namespace darwinop::remote {

struct ServerConfig {
  net::Ipv4 address = 0x7F000001;  // loopback
  std::uint16_t port = kUsualPort;
  std::vector<net::Network> allowed{{0x7F000000, 0xFF000000}};
  Nanos silence{
      std::chrono::milliseconds{500}};  // without a complete request: the robot holds and the lease is given back
  /// Rate limit: average time per piece of work (connection, read of 1 kB, reply), with bursts of 64. 0: no limit.
  Nanos pace{std::chrono::microseconds{500}};
  /// JPEG for clients without the extension while the robot has no camera: they cannot read a picture of 0 bytes, which
  /// is what they get if this is empty.
  std::vector<std::uint8_t> no_picture{};
};

class Server {
 public:
  using Clock = std::function<Nanos()>;
  /// Opens the robot's camera for a client that requests pictures; closed when the client no longer drives. Throws
  /// std::runtime_error if there is none. An empty function: no camera.
  using OpenPictures = std::function<std::unique_ptr<PictureSource>()>;

  /// Listens at once. Throws std::runtime_error with the remedy.
  Server(const ServerConfig& config, RobotPort& robot, OpenPictures open_pictures, Clock clock,
         net::BoundedLog::Log log);

  /// Waits at most `longest` for events and handles them.
  void poll(Nanos longest);

  /// Serves until `stop` becomes true; then up to 3 s more, for the last steps of a client with the extension, whose
  /// replies request its end. Leaves the session of another client open: the caller ends it.
  void run(const std::atomic<bool>& stop);

  [[nodiscard]] std::uint16_t port() const { return listener_.port(); }

 private:
  [[nodiscard]] int pollTimeout(Nanos longest) const;
  void serveClient();
  void handleRequests();
  [[nodiscard]] bool handle(const Request& request);
  [[nodiscard]] bool resume(const Request& request);
  [[nodiscard]] bool mayDrive(const Request& request);
  [[nodiscard]] bool startSession(const Request& request);
  void refuse(const Request& request, const std::string& what, const std::string& why);
  [[nodiscard]] bool mustAwait(std::uint64_t cycle, const Sensors& seen) const;
  [[nodiscard]] JpegPicture picture(const Request& request);
  /// In simulated time a request runs cycles and renders a picture, which may take seconds: the client waits meanwhile,
  /// so its silence starts now.
  void finishedWork() { client_->last_request_at = now_ = clock_(); }
  void openPictures();
  void accept();
  void checkSilence();
  void stopDriving();
  void endSession();
  void disconnect(const std::string& why);
  void reopen();
  void log(const std::string& what) { log_.line(what, now_); }
  void logRequestIssues(const RequestIssues& issues);
  void logStaleValues(const StaleValues& stale);

  ServerConfig config_;
  RobotPort& robot_;
  OpenPictures open_pictures_;
  Clock clock_;
  net::BoundedLog log_;
  net::RateLimiter rate_limiter_;
  net::Listener listener_;
  Nanos now_;
  bool ends_ = false;  // run() was requested to stop
  std::optional<Client> client_;
  std::unique_ptr<PictureSource> pictures_;  // while a client drives that has requested one
};

}  // namespace darwinop::remote
