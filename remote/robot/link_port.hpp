// RobotPort on a runtime::RobotLink: converts requests to the commands that a local controller would give.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/goals/motor_control.hpp"
#include "hal/frame_source.hpp"
#include "remote/jpeg/image_size.hpp"
#include "remote/picture_source.hpp"
#include "remote/server/robot_port.hpp"
#include "runtime/clock.hpp"
#include "runtime/driver_session.hpp"

namespace darwinop::remote {

class LinkPort final : public RobotPort {
 public:
  using Connect = std::function<std::unique_ptr<runtime::RobotLink>()>;

  enum class Home : bool {
    kDaemon,   // a link holds the lease: it exists while a client drives
    kEmbedded  // the loop runs in this process: one link from construction to destruction
  };

  /// endReason() of a loop that hangs.
  static constexpr const char* kNoCycle =
      "the robot's loop has not run a cycle for 1 s; check it with: darwinop runtime --status";

  /// Throws what `connect` throws if the home is kEmbedded.
  LinkPort(Home home, Connect connect, bool start_where_it_is);
  /// Ends an open session: safety does what [Safety] on_exit requests.
  ~LinkPort() override = default;

  void startSession(SessionStart start) override;
  void cancelSession() noexcept override;
  void apply(const Request& request) override;
  [[nodiscard]] Sensors sensors() override { return session_->sensors(); }
  [[nodiscard]] std::string endReason() override;
  [[nodiscard]] std::string endRequest() override { return end_request_; }
  void hold() noexcept override;
  void endSession() noexcept override;
  [[nodiscard]] bool realTime() const override { return session_->link().realTime(); }

  /// For the end of the program: ends the session of a client that has disconnected without ending it, if it is the
  /// robot's last one. Otherwise the robot would hold for gone_s before on_exit applies.
  void endAbandonedSession() noexcept;

  /// Opens the robot's camera in this pixel format. Throws std::runtime_error if there is none.
  using OpenFrames = std::function<std::unique_ptr<FrameSource>(runtime::RobotLink&, PictureForm)>;
  /// The robot's camera frames as JPEG. Call after startSession(); destroy before hold(). Throws what `open_frames`
  /// throws.
  [[nodiscard]] std::unique_ptr<PictureSource> openPictures(ImageSize size, const OpenFrames& open_frames,
                                                            const std::function<void(const std::string&)>& log);

 private:
  void applyMotor(const MotorSetting& setting);
  void applyLed(const LedSetting& setting);
  void clearCommands();
  void simulate();
  void simulateUntil(std::uint64_t cycle);

  Home home_;
  Connect connect_;
  bool start_where_it_is_;
  bool is_commanded_ = false;       // in this session
  std::uint32_t held_session_ = 0;  // of the last client that has left the robot holding; 0: none
  runtime::MonotonicClock clock_;
  std::optional<runtime::DriverSession> session_;
  std::vector<goals::MotorControl> motors_;  // by joint
  Commands commands_{};
  std::string end_request_;
  std::uint64_t last_cycle_ = 0;
  Nanos applied_at_{0}, last_cycle_at_{0}, simulated_at_{0};
};

}  // namespace darwinop::remote
