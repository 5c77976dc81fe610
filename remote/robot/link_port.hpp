// The robot of a controller's link, for the server: what the wire says becomes commands as a controller's would.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "core/motor_control.hpp"
#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"
#include "remote/picture_source.hpp"
#include "remote/server/robot_port.hpp"
#include "runtime/clock.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::remote {

class LinkPort final : public RobotPort {
 public:
  using Connect = std::function<std::unique_ptr<runtime::RobotLink>()>;

  enum class Home : bool {
    kDaemon,  // the link is the lease: there is one while a client drives
    kOwn      // the loop is in this process: there is one link, from now to the end
  };

  /// Throws what `connect` throws when the home is our own.
  LinkPort(Home home, Connect connect, bool start_where_it_is);
  /// Whoever drives says farewell: safety does what [Safety] on_exit asks for.
  ~LinkPort() override = default;

  void begin(Beginning beginning) override;
  void leaveAlone() noexcept override;
  void obey(const Request& request) override;
  [[nodiscard]] Sensors sensors() override { return link_->sensors(); }
  /// Cycle from which on safety speaks of who has begun last.
  [[nodiscard]] std::uint64_t firstOfOurs() const { return first_of_ours_; }
  [[nodiscard]] std::string mustEnd() override;
  /// For who drives by the robot's step. Returns, too, when the robot has gone: mustEnd() knows. Between begin() and
  /// hold().
  void waitForNextCycle();
  void hold() noexcept override;
  void farewell() noexcept override;
  [[nodiscard]] bool realTime() const override { return link_->realTime(); }

  /// At the end of the program. A client that has left gave the lease back without a farewell, and the robot holds for
  /// gone_s; said in its place, on_exit follows at once.
  void farewellForWhoLeft() noexcept;

  /// Opens what the robot sees, in this form. Throws std::runtime_error when it has no camera.
  using OpenFrames = std::function<std::unique_ptr<FrameSource>(runtime::RobotLink&, PictureForm)>;
  /// The robot's camera frames as JPEG. Between begin() and hold(), which it must not outlive. Throws what
  /// `open_frames` throws.
  [[nodiscard]] std::unique_ptr<PictureSource> openPictures(ImageSize size, const OpenFrames& open_frames,
                                                            const std::function<void(const std::string&)>& say);

 private:
  void listenTo(const MotorSetting& setting);
  void light(const LedSetting& setting);
  [[nodiscard]] Rad restingPlace(const Sensors& seen, std::size_t joint) const;
  void forgetWishes();
  void simulate(const Request& request);
  void simulateUntil(std::uint64_t cycle);

  Home home_;
  Connect connect_;
  bool start_where_it_is_, used_ = false;
  runtime::MonotonicClock clock_;
  std::unique_ptr<runtime::RobotLink> link_;
  std::vector<MotorControl> motors_;  // by joint
  Commands commands_{};
  std::uint64_t first_of_ours_ = 0;  // cycle from which on safety speaks of this client
  std::uint64_t last_cycle_ = 0;
  Nanos obeyed_{0}, last_cycle_at_{0}, simulated_{0};
};

}  // namespace darwinop::remote
