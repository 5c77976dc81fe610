// Robot link over TCP to `darwinop remote`: one request and one reply per step, in the controller's thread.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
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
  /// For requests before the first publish(): the server may begin the session with one of them.
  bool start_where_it_is = false;
};

/// Cycles are those of the robot's loop, numbered in each reply. Without replies, cycles are counted by the local clock
/// and all values age with them; after 0.5 s the robot counts as holding, after a lost connection as offline. A server
/// of 2013 sends no cycle numbers: then the local clock counts periods of 16 ms, and a step returns the values of its
/// start.
class TcpLink final : public runtime::RobotLink {
 public:
  /// Connects and waits for the first reply. Throws std::runtime_error with the remedy.
  explicit TcpLink(TcpOptions options);
  ~TcpLink() override;

  [[nodiscard]] Nanos period() const override { return server_.period; }
  [[nodiscard]] Nanos now() const override { return server_.real_time ? clock_.now() : Nanos{shown_.time_ns}; }
  [[nodiscard]] bool realTime() const override { return server_.real_time; }
  [[nodiscard]] bool bringsToRest() const override { return false; }
  void publish(Commands commands) override;
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;
  /// Also sends the commands published last.
  void leaveHolding() override;
  [[nodiscard]] Sensors sensors() const override { return shown_; }
  [[nodiscard]] std::string whyEnded() const override { return why_ended_.empty() ? end_request_ : why_ended_; }
  [[nodiscard]] std::unique_ptr<FrameSource> openCamera(int width, int height) override;

 private:
  struct Server {
    bool extended = true;   // supports the extension; assumed until a reply lacks it
    bool real_time = true;  // its loop runs by the clock
    Nanos period{16'000'000};
  };
  struct Loss {
    std::optional<Nanos> since;      // of the connection; nullopt: never lost in this session
    std::optional<Nanos> logged_at;  // `since` of the last loss that was logged
    Nanos attempted_at{0};           // last attempt to reconnect
    [[nodiscard]] bool isLogged() const { return logged_at == since; }
  };
  struct LastRequest {
    std::uint64_t cycle = 0;
    Nanos sent_at{0};
    bool for_picture = false;
  };

  void connect();
  void awaitFirstReply();
  void send(std::uint64_t cycle);
  void receive(Nanos longest);
  void take(const Reply& reply);
  [[nodiscard]] bool takeImage(const ReplyExtension& extension, TcpState before);
  void takeLegacy(const Reply& reply, TcpState before);
  void checkSpeed(const Reply& reply);
  void reconnect();
  void detectLoss();
  void ageShownImage();
  [[nodiscard]] bool hasImage(std::uint64_t cycle) const { return image_.cycle >= cycle; }
  [[nodiscard]] bool mustRequest(std::uint64_t cycle) const;
  [[nodiscard]] Nanos expected(std::uint64_t cycle) const;
  [[nodiscard]] std::uint64_t cyclesOnTheWay(std::uint64_t cycle, Nanos held) const;
  [[nodiscard]] Nanos replyGrace() const;
  [[nodiscard]] bool reportsEndRequest() {
    return !end_request_.empty() && !std::exchange(end_request_reported_, true);
  }
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

  TcpState state_ = TcpState::kFirstContact;
  Server server_;
  Loss loss_;
  LastRequest last_request_;
  std::optional<Commands> commands_;  // published last
  bool was_driven_ = false;           // the robot has been under torque in this session
  const bool unattended_ = runtime::startedUnattended();

  Sensors image_{};                // of the last reply, in cycles and time of this link
  Nanos image_at_{0};              // when it was received
  Sensors shown_{};                // image_, aged by the cycles since then
  std::uint64_t cycle_ahead_ = 0;  // this link's cycle number minus the robot's, modulo 2^64
  std::int64_t time_ahead_ns_ = 0;
  Nanos step_{0};
  std::uint64_t stepped_to_ = 0;  // end of the present step of length step_
  std::string why_ended_;
  std::string end_request_;  // the robot ends soon; a wait has returned false for it if it is `reported`
  bool end_request_reported_ = false;
};

}  // namespace darwinop::remote
