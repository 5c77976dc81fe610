// Drives a robot through a RobotLink: take over, publish, wait for cycles, hold or end; reason of the end.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

#include "core/commands.hpp"
#include "core/sensors.hpp"
#include "runtime/robot_link.hpp"

namespace darwinop::runtime {

/// The worst fault: "temperature above 75 C (LegLowerL, id 14); <remedy>".
std::string describe(const SafetyReport& report);

/// Used by one thread. The destructor ends the session as configured by [Safety] on_exit, unless hold() was called
/// last.
class DriverSession {
 public:
  /// `link` holds the lease.
  explicit DriverSession(std::unique_ptr<RobotLink> link) : link_{std::move(link)} {}

  /// Takes over with the next commands. A further call begins a new session: RobotLink::beginSession().
  void start();
  /// First cycle whose safety report is certain to refer to this session: one that runs during start(), or during the
  /// first publish(), may not.
  [[nodiscard]] std::uint64_t firstCycle() const { return first_cycle_; }
  /// True once safety executes this session's commands: any move to the start pose is over.
  [[nodiscard]] bool drives(const Sensors& seen) const;

  void publish(const Commands& commands);
  [[nodiscard]] Sensors sensors() const { return link_->sensors(); }
  /// Waits until the loop has finished cycle number `cycle`. False: the loop has ended, or `stop` is true; see
  /// loopEnd().
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle, const std::atomic<bool>& stop);
  [[nodiscard]] bool waitForCycle(std::uint64_t cycle);

  /// A fault that ends this session, and its remedy; empty: none.
  [[nodiscard]] std::string faultEnd(const Sensors& seen) const;
  /// Why the loop has ended; empty: it runs. Never blocks.
  [[nodiscard]] std::string loopEnd(const Sensors& seen);

  /// Sets each joint's goal in `commands` to its present position and publishes them with Commands::hold. The robot
  /// then holds until the next session begins, at most gone_s; one without torque stays limp. No effect before the
  /// first publish(), or if the loop ends with the link (RobotLink::bringsToRest()).
  void hold(Commands& commands);
  /// Ends the session as configured by [Safety] on_exit.
  void end(Commands last);

  [[nodiscard]] RobotLink& link() { return *link_; }
  [[nodiscard]] const RobotLink& link() const { return *link_; }

 private:
  std::unique_ptr<RobotLink> link_;
  bool started_ = false, published_ = false;
  std::uint64_t first_cycle_ = 0;
};

}  // namespace darwinop::runtime
