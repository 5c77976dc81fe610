// The monitor channel: what observers are told of the robot. docs/monitor.md is the contract.
#pragma once

#include <unistd.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "hal/net/web/channel.hpp"
#include "monitor/colour_search.hpp"
#include "monitor/eye.hpp"
#include "monitor/onlooker.hpp"
#include "monitor/pace.hpp"
#include "monitor/wishes.hpp"
#include "runtime/fault_announcer.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::monitor {

/// One thread: the web server's. Reads shared memory; the loop never notices.
class Monitor final : public web::ChannelUser {
 public:
  using Clock = std::function<Nanos()>;
  static constexpr std::size_t kNotices = 20;  // a newcomer is told of the last ones

  /// `search`: what the frames of those functions are shown to; none: nothing is ever found.
  Monitor(const runtime::RuntimeFiles& files, Clock clock, Eye::Open open_camera, Eye::Open share_camera = {},
          std::shared_ptr<ColourSearch> search = nullptr);

  void opened(web::Channel& channel) override;
  void said(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override {
    seats_.erase(&channel);
    searches_changed_ = true;
  }

  /// Looks at the robot and tells everybody what they are due. To be called again after pause(), or earlier.
  void look();
  [[nodiscard]] Nanos pause() const;

  /// Who drives in this very process opens no camera: it stays with the onlookers meanwhile.
  void leaveCameraHere() { own_driver_ = getpid(); }

  /// Something that everybody should know.
  void notice(const std::string& text);

 private:
  struct Seat {
    Wishes wishes{};
    Pace state{}, pictures{};
    std::uint64_t cycle = 0;    // sent last
    std::uint64_t picture = 0;  // sent last
    std::string camera;         // what was said of the camera
  };
  struct Figures {
    runtime::StatsView all{}, before{}, recent{};
  };

  void turn();
  void tellWhatIs(web::Channel& channel);
  void lookAtState();
  void lookAtFaults();
  void lookAtLoop();
  void lookAtCamera();
  void updateSearches();
  void tellOfCamera(web::Channel& channel, Seat& seat, bool seeing);
  [[nodiscard]] bool everyCycle(const Seat& seat) const;

  Onlooker onlooker_;
  Clock clock_;
  Eye eye_;
  std::shared_ptr<ColourSearch> search_;
  bool searches_changed_ = false;
  Nanos now_{0};
  std::map<web::Channel*, Seat> seats_;

  Sensors seen_{};
  web::Bytes state_text_;
  std::uint64_t state_cycle_ = 0;
  std::string faults_text_;
  Pace faults_pace_, loop_pace_, driver_pace_;
  pid_t driver_ = 0, own_driver_ = 0;
  std::unique_ptr<Figures> figures_ = std::make_unique<Figures>();
  Nanos figures_time_{0};
  bool figures_any_ = false;

  std::ostringstream announced_;
  std::unique_ptr<runtime::FaultAnnouncer> announcer_;
  std::deque<web::Bytes> notices_;
  std::uint64_t notice_number_ = 0;
};

}  // namespace darwinop::monitor
