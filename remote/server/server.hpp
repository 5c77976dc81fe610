// The server: one thread, one client that drives, nothing that waits for the robot, an encoder or a slow network.
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
#include "hal/net/allowance.hpp"
#include "hal/net/bounded_log.hpp"
#include "hal/net/listener.hpp"
#include "remote/picture_source.hpp"
#include "remote/server/client.hpp"
#include "remote/server/robot_port.hpp"

namespace darwinop::remote {

struct ServerConfig {
  net::Ipv4 address = 0x7F000001;  // loopback
  std::uint16_t port = kUsualPort;
  std::vector<net::Network> allowed{{0x7F000000, 0xFF000000}};
  Nanos silence{std::chrono::milliseconds{500}};  // without a whole request: motion is held, the lease given back
  /// Between two pieces of work (a caller, a read of 1 kB, an answer) on average; 64 may come at once. 0: no limit.
  Nanos pace{std::chrono::microseconds{500}};
};

class Server {
 public:
  using Clock = std::function<Nanos()>;
  /// Opens the robot's eye for a client that asks for pictures; it is closed when the client no longer drives. Throws
  /// std::runtime_error when there is none. An empty function: there is none.
  using OpenPictures = std::function<std::unique_ptr<PictureSource>()>;

  /// Listens from now on. Throws std::runtime_error with what to do.
  Server(const ServerConfig& config, RobotPort& robot, OpenPictures open_pictures, Clock clock,
         net::BoundedLog::Say say);

  /// Waits at most `longest` for something to happen, and sees to it.
  void attend(Nanos longest);

  /// Until `stop` becomes true. Who drives then still drives: the robot's end is the caller's affair.
  void run(const std::atomic<bool>& stop);

  [[nodiscard]] std::uint16_t port() const { return listener_.port(); }

 private:
  [[nodiscard]] int waitFor(Nanos longest) const;
  void seeToClient();
  void answerAll();
  [[nodiscard]] bool answer(const Request& request);
  [[nodiscard]] bool answerAgain(const Request& request);
  [[nodiscard]] bool mayDrive(const Request& request);
  void refuse(const Request& request, const std::string& what, const std::string& why);
  [[nodiscard]] bool isToCome(std::uint64_t cycle, const Sensors& seen) const;
  [[nodiscard]] JpegPicture picture(const Request& request);
  void openPictures();
  void letIn();
  void lookForSilence();
  void stopDriving();
  void sayFarewell();
  void showOut(const std::string& why);
  void openDoor();
  void log(const std::string& what) { log_.line(what, now_); }
  void tellOddities(const Oddities& oddities);
  void tellDoubts(const Doubts& doubts);

  ServerConfig config_;
  RobotPort& robot_;
  OpenPictures open_pictures_;
  Clock clock_;
  net::BoundedLog log_;
  net::Allowance allowance_;
  net::Listener listener_;
  Nanos now_;
  std::optional<Client> client_;
  std::unique_ptr<PictureSource> pictures_;  // while a client drives that has asked for one
};

}  // namespace darwinop::remote
