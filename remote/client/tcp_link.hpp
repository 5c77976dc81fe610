// A robot behind `darwinop remote`: each step is an exchange with its server. No thread: the controller's does it all.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "remote/client/connection.hpp"
#include "remote/client/link_speed.hpp"
#include "remote/client/pictures.hpp"
#include "remote/client/wishes.hpp"
#include "runtime/clock.hpp"
#include "runtime/fault_announcer.hpp"
#include "runtime/names.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::remote {

struct TcpOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = kUsualPort;
  Nanos first_patience{10'000'000'000};  // for a server to be there, and again for its first reply
  Nanos patience{30'000'000'000};        // for one that was there and is gone
  Nanos silence{2'000'000'000};          // without the reply, after which a connection is no longer one
  std::function<void(const std::string&)> say;
};

/// A cycle of this link is one of the robot's loop, as its number comes with each reply. While replies do not come,
/// cycles are counted by the clock here, and all values grow old with them. A server of 2013 tells no cycles: then the
/// clock here counts periods of 16 ms, and a step's values are those of its beginning, as they were then.
class TcpLink final : public runtime::RobotLink {
 public:
  /// Connects, and has the first reply. Throws std::runtime_error with what to do.
  explicit TcpLink(TcpOptions options);
  ~TcpLink() override;

  [[nodiscard]] Nanos period() const override { return period_; }
  [[nodiscard]] Nanos now() const override { return real_time_ ? clock_.now() : Nanos{shown_.time_ns}; }
  [[nodiscard]] bool realTime() const override { return real_time_; }
  [[nodiscard]] bool bringsToRest() const override { return false; }
  void publish(Commands commands) override;
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) override;
  /// Sends what was published last, too.
  void leaveHolding() override;
  [[nodiscard]] Sensors sensors() const override { return shown_; }
  [[nodiscard]] std::string whyEnded() const override { return why_ended_; }
  [[nodiscard]] std::unique_ptr<FrameSource> openEyes(int width, int height) override;

 private:
  void connectFirst();
  void firstReply();
  void send(std::uint64_t cycle);
  void listen(Nanos longest);
  void take(const Reply& reply);
  void takeImage(const ReplyExtension& extension, bool first);
  void takeOld(const Reply& reply, bool first);
  void judgeSpeed(const Reply& reply);
  void reconnect();
  void noticeLoss();
  void growOld();
  [[nodiscard]] bool isThere(std::uint64_t cycle) const { return image_.cycle >= cycle; }
  [[nodiscard]] bool isToAsk(std::uint64_t cycle) const;
  [[nodiscard]] Nanos expected(std::uint64_t cycle) const;
  [[nodiscard]] std::uint64_t cyclesOnTheWay(std::uint64_t cycle, Nanos held) const;
  [[nodiscard]] Nanos patienceWithReply() const;
  [[nodiscard]] bool mayGoOn(const std::atomic<bool>& stop);
  bool end(const std::string& why);
  void say(const std::string& sentence) const;
  [[nodiscard]] std::string name() const;

  TcpOptions options_;
  runtime::MonotonicClock clock_;
  std::vector<std::uint32_t> addresses_;
  std::size_t next_address_ = 0;
  Connection connection_;
  Wishes wishes_;
  Pictures pictures_;
  LinkSpeed speed_;
  runtime::FaultAnnouncer faults_;

  Commands wanted_{};
  bool was_up_ = false;  // the robot has been seen driven
  bool unattended_ = runtime::startedUnattended();
  bool drove_ = false, lost_ = false, came_back_ = false;
  bool extended_ = true;  // the server knows the extension; believed until a reply lacks it
  bool greeted_ = false;  // this connection's first reply is there
  bool real_time_ = true;
  bool says_farewell_ = true;
  Nanos period_{16'000'000};

  Sensors image_{};                // as the last reply told it, in cycles and time of this link
  Nanos image_at_{0};              // when that came
  Sensors shown_{};                // that, grown old by as many cycles as went by since
  std::uint64_t cycle_ahead_ = 0;  // of this link's cycles before the robot's; unsigned numbers may wrap
  std::int64_t time_ahead_ns_ = 0;
  Nanos sent_{0}, attempted_{0}, lost_since_{0}, step_{0};
  std::uint64_t stepped_to_ = 0;     // end of the step under way, which takes step_
  bool tells_ = false;               // of the loss under way, and its end
  std::optional<Nanos> told_at_;     // of a loss, the last time
  std::uint64_t exchanged_for_ = 0;  // what the last request was made for
  bool picture_asked_ = false;       // by it
  bool overdue_ = false;             // its reply has been given up on for now
  std::string why_ended_;
};

}  // namespace darwinop::remote
