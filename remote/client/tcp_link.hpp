// Robot link over TCP to `darwinop remote`: one request and one reply per step, in the controller's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "remote/client/command_delta.hpp"
#include "remote/client/connection.hpp"
#include "remote/client/link_speed.hpp"
#include "remote/client/pictures.hpp"
#include "remote/client/tcp_states.hpp"
#include "runtime/clock.hpp"
#include "runtime/fault_announcer.hpp"
#include "runtime/names.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::remote {

struct TcpOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = kUsualPort;
  Nanos connect_timeout{10'000'000'000};    // until connected, and again for the first reply
  Nanos reconnect_timeout{30'000'000'000};  // after a lost connection
  Nanos reply_timeout{2'000'000'000};       // without a reply: the connection counts as lost
  std::function<void(const std::string&)> log;
};

/// Cycles are those of the robot's loop, numbered in each reply. Without replies, cycles are counted by the local clock
/// and all values age with them. A server of 2013 sends no cycle numbers: then the local clock counts periods of 16 ms,
/// and a step returns the values of its start.
class TcpLink final : public runtime::RobotLink {
 public:
  /// Connects and waits for the first reply. Throws std::runtime_error with the remedy.
  explicit TcpLink(TcpOptions options);
  ~TcpLink() override;

  [[nodiscard]] Nanos period() const override { return period_; }
  [[nodiscard]] Nanos now() const override { return real_time_ ? clock_.now() : Nanos{shown_.time_ns}; }
  [[nodiscard]] bool realTime() const override { return real_time_; }
  [[nodiscard]] bool bringsToRest() const override { return false; }
  void publish(Commands commands) override;
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;
  /// Also sends the commands published last.
  void leaveHolding() override;
  [[nodiscard]] Sensors sensors() const override { return shown_; }
  [[nodiscard]] std::string whyEnded() const override { return why_ended_; }
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height) override;

 private:
  void connect();
  void awaitFirstReply();
  void send(std::uint64_t cycle);
  void receive(Nanos longest);
  void take(const Reply& reply);
  void takeImage(const ReplyExtension& extension, bool first);
  void takeLegacy(const Reply& reply, bool first);
  void checkSpeed(const Reply& reply);
  void reconnect();
  void detectLoss();
  void ageShownImage();
  [[nodiscard]] bool hasImage(std::uint64_t cycle) const { return image_.cycle >= cycle; }
  [[nodiscard]] bool mustRequest(std::uint64_t cycle) const;
  [[nodiscard]] Nanos expected(std::uint64_t cycle) const;
  [[nodiscard]] std::uint64_t cyclesOnTheWay(std::uint64_t cycle, Nanos held) const;
  [[nodiscard]] Nanos replyGrace() const;
  [[nodiscard]] bool isRunning(const std::atomic<bool>& stop);
  bool end(const std::string& why);
  void log(const std::string& message) const;
  [[nodiscard]] std::string name() const;

  TcpOptions options_;
  runtime::MonotonicClock clock_;
  std::vector<std::uint32_t> addresses_;
  std::size_t next_address_ = 0;
  Connection connection_;
  CommandDelta command_delta_;
  Pictures pictures_;
  LinkSpeed speed_;
  runtime::FaultAnnouncer faults_;

  Commands commands_{};
  bool was_driven_ = false;  // the robot has been under torque in this session
  bool unattended_ = runtime::startedUnattended();
  TcpState state_ = TcpState::kFirstContact;
  bool has_commands_ = false;
  bool reconnected_ = false;  // a connection has been lost in this session
  bool extended_ = true;      // the server supports the extension; assumed until a reply lacks it
  bool real_time_ = true;
  bool ends_session_ = true;
  Nanos period_{16'000'000};

  Sensors image_{};                // of the last reply, in cycles and time of this link
  Nanos image_at_{0};              // when it was received
  Sensors shown_{};                // image_, aged by the cycles since then
  std::uint64_t cycle_ahead_ = 0;  // this link's cycle number minus the robot's, modulo 2^64
  std::int64_t time_ahead_ns_ = 0;
  Nanos sent_{0}, attempted_{0}, lost_since_{0}, step_{0};
  std::uint64_t stepped_to_ = 0;         // end of the present step of length step_
  bool logs_loss_ = false;               // log the present loss and its end
  std::optional<Nanos> loss_logged_at_;  // when a loss was logged last
  std::uint64_t exchanged_for_ = 0;      // cycle of the last request
  bool picture_asked_ = false;           // in the last request
  std::string why_ended_;
};

}  // namespace darwinop::remote
