// The one way to drive a robot: take over, publish, wait for cycles, hold or end, and why it ended.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::runtime {

/// "temperature above 75 C (LegLowerL, id 14); <remedy>": the worst fault.
std::string describe(const SafetyReport& report);

/// Used by one thread. Its destructor ends the session as [Safety] on_exit says, unless hold() was last.
class DriverSession {
 public:
  /// `link` holds the lease.
  explicit DriverSession(std::unique_ptr<RobotLink> link) : link_{std::move(link)} {}

  /// Takes over with the next commands. Once more on the same link: a new driver for safety, which starts gently.
  void start();
  /// First cycle whose safety report is about this session: the one under way at start() may have begun before.
  [[nodiscard]] std::uint64_t firstCycle() const { return first_cycle_; }
  /// Safety lets this session drive: the move to the start pose, if any, is over.
  [[nodiscard]] bool drives(const Sensors& seen) const;

  void publish(const Commands& commands) { link_->publish(commands); }
  [[nodiscard]] Sensors sensors() const { return link_->sensors(); }
  /// False: the loop has ended, or `stop` is true; see loopEnd().
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop);
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle);

  /// A fault that ends this session, and its remedy; empty: none.
  [[nodiscard]] std::string faultEnd(const Sensors& seen) const;
  /// Why there is no loop to drive any more; empty: it runs. Never blocks.
  [[nodiscard]] std::string loopEnd(const Sensors& seen);

  /// Makes each joint's present position the goal in `commands` and publishes them. The robot holds until the next
  /// driver comes, at most gone_s; without effect where the end of the link is the end of the loop.
  void hold(Commands& commands);
  /// Ends it as [Safety] on_exit says.
  void end(Commands last);

  [[nodiscard]] RobotLink& link() { return *link_; }
  [[nodiscard]] const RobotLink& link() const { return *link_; }

 private:
  std::unique_ptr<RobotLink> link_;
  bool started_ = false;
  std::uint64_t first_cycle_ = 0;
};

}  // namespace darwinop::runtime
