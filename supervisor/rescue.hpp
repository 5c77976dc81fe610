// Brings a robot to rest whose runtime is gone: MX-28 servos keep their last goal for ever.
#pragma once

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

#include "hal/byte_line.hpp"
#include "hal/cm730/joint_offsets.hpp"
#include "hal/cm730/usb_serial.hpp"
#include "runtime/names.hpp"
#include "safety/config.hpp"
#include "supervisor/rescue_watch.hpp"

namespace darwinop::supervisor {

/// What the rescue needs to know of the robot. Read while all is well.
struct RobotSettings {
  std::string port = "/dev/ttyUSB0";
  Nanos period{16'000'000};
  safety::Config safety{};
  cm730::JointOffsets offsets{};
  gid_t group = static_cast<gid_t>(-1);        // who may look on
  std::optional<cm730::UsbIdentity> identity;  // of the port: a device that was plugged out comes back as ttyUSB1
};

/// A loop like the runtime's, in this process, with nobody driving it: the same limits, the same slow crouch, the same
/// reactions to faults. A robot whose servos are all limp stays as it is. Onlookers see it as they see the runtime, and
/// a controller that comes is refused.
class Rescue {
 public:
  enum class Step { kOpening, kHold, kCrouch, kAtRest, kStiff };

  /// `released`: the robot was released, or lost its power, before its runtime failed. It is not moved: torque goes off
  /// where a servo still holds.
  Rescue(const RobotSettings& robot, const runtime::RuntimeFiles& files, bool released);
  ~Rescue();
  Rescue(const Rescue&) = delete;
  Rescue& operator=(const Rescue&) = delete;

  /// Call every 50 ms or so. An attempt to open the port can take a second.
  [[nodiscard]] Step look(Nanos now);
  /// Why the port could not be opened in the last attempt; empty: it is open, or was not tried yet.
  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }
  /// The board answers.
  [[nodiscard]] bool online() const;

 private:
  class OwnLoop;
  void open(Nanos now);

  RobotSettings robot_;
  runtime::RuntimeFiles files_;
  bool released_;
  std::unique_ptr<OwnLoop> loop_;
  std::string obstacle_;
  Nanos next_try_{0}, wait_;
};

}  // namespace darwinop::supervisor
