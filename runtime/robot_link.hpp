// Interface of a robot for its controller: publish commands, wait for a cycle, read sensors.
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
  virtual ~RobotLink() = default;  ///< Ends the session: safety then executes [Safety] on_exit.

  /// Nominal period of the loop.
  [[nodiscard]] virtual Nanos period() const = 0;
  /// Time on the loop's clock: monotonic on a robot, simulated in lockstep.
  [[nodiscard]] virtual Nanos now() const = 0;
  /// False in lockstep: cycles run only inside waitForCycle(), as fast as the machine allows.
  [[nodiscard]] virtual bool realTime() const = 0;

  /// True if the loop ends with this link: the destructor then brings the robot to rest first, which takes seconds in
  /// real time.
  [[nodiscard]] virtual bool bringsToRest() const { return realTime(); }

  /// Begins another session, which safety starts gently. No effect over TCP, where a session lasts as long as the
  /// connection.
  virtual void beginSession() {}

  /// Publishes commands; the loop uses the newest ones. Session and sequence numbers are filled in here. Never blocks.
  virtual void publish(Commands commands) = 0;

  /// Waits until the loop has finished cycle number `cycle` (Sensors::cycle). False: the controller must end, because
  /// `stop` is true, because daemon or server were requested to end, which is reported once, or because the loop has
  /// ended (the daemon died). In the first two cases later waits may succeed, for the last steps of a walk. whyEnded()
  /// is then a message for the user, except after `stop`.
  [[nodiscard]] virtual bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop) = 0;

  /// The destructor will not end the session: the robot holds, as after a controller crash, until the next session
  /// begins, at most gone_s. No effect if the loop ends with this link.
  virtual void leaveHolding() {}

  /// The newest consistent image. Never blocks.
  [[nodiscard]] virtual Sensors sensors() const = 0;

  [[nodiscard]] virtual std::string whyEnded() const = 0;

  /// Camera of a simulated or remote robot, with this picture size; used by the thread that waits for cycles. The link
  /// must outlive it. Null: the camera is connected to this computer, or there is none.
  [[nodiscard]] virtual std::unique_ptr<FrameSource> openCamera(int /*width*/, int /*height*/) { return nullptr; }
};

}  // namespace darwinop::runtime
