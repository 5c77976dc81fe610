// Monitor channel: publishes the robot's state to observers. Protocol: docs/monitor.md.
#pragma once

#include <unistd.h>

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <sstream>
#include <string>

#include "hal/net/web/channel.hpp"
#include "monitor/camera_source.hpp"
#include "monitor/colour_search.hpp"
#include "monitor/pace.hpp"
#include "monitor/runtime_observer.hpp"
#include "monitor/subscription.hpp"
#include "runtime/fault_announcer.hpp"
#include "runtime/loop_stats.hpp"

namespace darwinop::monitor {

/// Runs in the web server's thread. Maps the runtime's memory read-only, so it cannot disturb the loop.
class Monitor final : public web::ChannelHandler {
 public:
  using Clock = std::function<Nanos()>;
  static constexpr const char* kNoSharedPictures = "a controller drives and shares no pictures of 320x240";
  static constexpr const char* kCameraIsBlind = "the camera gives no pictures";
  static constexpr std::size_t kNotices = 20;  // kept for observers that connect later

  /// `search`: searches the frames of these functions; null: searches have no results.
  Monitor(const runtime::RuntimeFiles& files, Clock clock, CameraSource::Open open_camera,
          CameraSource::Open share_camera = {}, std::shared_ptr<ColourSearch> search = nullptr);

  void opened(web::Channel& channel) override;
  void received(web::Channel& channel, std::string_view message, bool binary) override;
  void closed(web::Channel& channel) noexcept override {
    subscribers_.erase(&channel);
    searches_changed_ = true;
  }

  /// Reads the robot's state and sends what is due. Call it again after pause() or earlier.
  void update();
  [[nodiscard]] Nanos pause() const;

  /// A drive session of this process does not open the camera, so observers keep it during that session.
  void keepCameraForObservers() { own_driver_ = getpid(); }

  /// Sends a notice to all subscribers, also to later ones.
  void notice(const std::string& text);

 private:
  struct Subscriber {
    Subscription subscription{};
    Pace state{}, pictures{};
    std::uint64_t cycle = 0;    // last one sent
    std::uint64_t picture = 0;  // last one sent
    std::string camera;         // camera status sent last
  };
  struct Figures {
    runtime::StatsView all{}, before{}, recent{};
  };

  void resetForRuntime();
  void sendRuntimeStatus(web::Channel& channel);
  void publishState();
  void publishFaults();
  void publishLoopStats();
  void publishPictures();
  void updateSearches();
  void sendCameraStatus(web::Channel& channel, Subscriber& subscriber, bool seeing);
  [[nodiscard]] bool everyCycle(const Subscriber& subscriber) const;

  RuntimeObserver runtime_;
  Clock clock_;
  CameraSource camera_;
  std::shared_ptr<ColourSearch> search_;
  bool searches_changed_ = false;
  Nanos now_{0};
  std::map<web::Channel*, Subscriber> subscribers_;

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
