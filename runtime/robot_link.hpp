// What a controller holds of a robot, whichever kind it is: publish commands, wait for a cycle, read sensors.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "hal/byte_line.hpp"
#include "hal/frame_source.hpp"

namespace darwinop::runtime {

/// Used by one thread of the controller.
class RobotLink {
 public:
  virtual ~RobotLink() = default;  ///< Ends the session: safety then does what [Safety] on_exit asks for.

  /// Nominal period of the loop.
  [[nodiscard]] virtual Nanos period() const = 0;
  /// Time on the loop's clock: monotonic on a robot, simulated in lockstep.
  [[nodiscard]] virtual Nanos now() const = 0;
  /// False in lockstep, where a cycle runs when it is waited for and as fast as the machine allows.
  [[nodiscard]] virtual bool realTime() const = 0;

  /// True when the end of this link is the end of the loop, which first brings the robot to rest: seconds in real time.
  [[nodiscard]] virtual bool bringsToRest() const { return realTime(); }

  /// Offers an image to the loop; the newest one wins. Session and sequence are filled in here. Never waits.
  virtual void publish(Commands commands) = 0;

  /// Waits until the loop has finished cycle number `cycle` (Sensors::cycle). False when the robot is gone for
  /// good (the daemon died) or `stop` became true; whyEnded() then has a sentence for the user.
  [[nodiscard]] virtual bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) = 0;

  /// Does not end the session: the robot holds, as after a controller that died, and the next one may come within
  /// gone_s. A link whose end is the end of the loop knows no such thing.
  virtual void leaveHolding() {}

  /// The newest consistent image. Never waits.
  [[nodiscard]] virtual Sensors sensors() const = 0;

  [[nodiscard]] virtual std::string whyEnded() const = 0;

  /// The camera of a robot that is not part of this computer, for pictures of this size; the link has to outlive it,
  /// and the thread that waits for cycles uses it. Null: the robot's eye is a camera of this computer, or it has none.
  [[nodiscard]] virtual std::unique_ptr<FrameSource> openCamera(int /*width*/, int /*height*/) { return nullptr; }
};

}  // namespace darwinop::runtime
