// Brings the robot to rest after a runtime failure: MX-28 servos hold their last goal indefinitely.
#pragma once

#include <sys/types.h>

#include <memory>
#include <optional>
#include <string>

#include "connect/serial_bus.hpp"
#include "core/sensors.hpp"
#include "hal/byte_line.hpp"
#include "hal/cm730/usb_serial.hpp"
#include "runtime/names.hpp"
#include "supervisor/rescue_watch.hpp"

namespace darwinop::supervisor {

/// Robot configuration for the rescue, read before the failure.
struct RobotSettings {
  connect::SerialRobot serial;
  gid_t group = static_cast<gid_t>(-1);        // group with read access
  std::optional<cm730::UsbIdentity> identity;  // of the port: after replugging, the device may become ttyUSB1
};

/// A loop like the runtime's, in this process, without a driver: same limits, same slow crouch, same fault reactions.
/// If all servos are limp, the robot stays as it is. Observers read it like the runtime; controllers are rejected.
class Rescue {
 public:
  enum class Step { kOpening, kHold, kCrouch, kAtRest, kStiff };

  /// `released`: the robot was released, or lost power, before the runtime failed. It is not moved: torque goes off
  /// where a servo still holds.
  Rescue(const RobotSettings& robot, const runtime::RuntimeFiles& files, bool released);
  ~Rescue();
  Rescue(const Rescue&) = delete;
  Rescue& operator=(const Rescue&) = delete;

  /// Call about every 50 ms. Opening the port may take a second.
  [[nodiscard]] Step update(Nanos now);
  /// Error of the last attempt to open the port; empty: open, or not tried yet.
  [[nodiscard]] const std::string& obstacle() const { return obstacle_; }
  /// Newest image of its loop; cycle 0: none.
  [[nodiscard]] Sensors sensors() const;
  /// The board responds.
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
