// The safety layer: turns a controller's commands into commands that may be sent to the bus.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/commands.hpp"
#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "safety/board_watch.hpp"
#include "safety/config.hpp"
#include "safety/driver_watch.hpp"
#include "safety/fault_book.hpp"
#include "safety/joint_guard.hpp"
#include "safety/pose_move.hpp"
#include "safety/states.hpp"

namespace darwinop::safety {

/// Owned by the loop. Deterministic: no I/O, no clock, no heap; time is the number of cycles times the period.
class Guard {
 public:
  /// Throws std::runtime_error if the configuration is out of range or contradicts itself.
  explicit Guard(const Config& config);
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;

  /// Once a cycle. `asked`: newest commands (session 0: no session yet). `seen`: sensors after the previous cycle,
  /// default-constructed before the first.
  [[nodiscard]] SafeCommands vet(const Commands& asked, const Sensors& seen) noexcept;

  /// Result of the last vet().
  [[nodiscard]] const SafetyReport& report() const noexcept { return report_; }

 private:
  using Joints = std::array<JointGuard, kJoints>;
  using Shares = std::array<double, kJoints>;

  void take(const Commands& asked, Nanos dt) noexcept;
  [[nodiscard]] bool excusesSilence() const noexcept;
  void watch(const Sensors& seen, Nanos dt) noexcept;
  void watchHold() noexcept;
  void beginSession(const Commands& asked) noexcept;
  void reportSettings() noexcept;
  void clearFaults() noexcept;
  void noteFaults() noexcept;

  void changeState(const Sensors& seen, Nanos dt) noexcept;
  [[nodiscard]] Reaction demanded() const noexcept;
  [[nodiscard]] std::optional<Event> findEvent() const noexcept;
  [[nodiscard]] std::optional<Event> findEventOf(State state, bool wanted, bool hold) const noexcept;
  [[nodiscard]] std::optional<Event> findEventOffline() const noexcept;
  [[nodiscard]] std::optional<Event> findEventAtRest() const noexcept;
  [[nodiscard]] bool anyStiff() const noexcept;
  [[nodiscard]] bool allKnown() const noexcept;
  [[nodiscard]] bool holds() const noexcept;
  [[nodiscard]] bool stillLimp() const noexcept;
  [[nodiscard]] bool takenOver() const noexcept;
  void runTimers(const Sensors& seen, Nanos dt) noexcept;
  void act(Event event) noexcept;
  void finishStart() noexcept;

  /// Safety moves the robot: to the start pose, or into a kneel.
  [[nodiscard]] bool movesByItself() const noexcept { return state_ == State::kStarting || state_ == State::kKneeling; }
  [[nodiscard]] Shares shares() const noexcept;
  void moveJoints(double speed, Nanos dt) noexcept;
  [[nodiscard]] SafeCommands compose(Nanos dt) noexcept;
  [[nodiscard]] Rad target(std::size_t joint) const noexcept;
  void writeReport() noexcept;

  const Config robot_config_;  // applies while no session makes it stricter
  Config config_;              // of this session; referenced by the members below
  std::array<Rad, kJoints> start_pose_;
  DriverWatch driver_;
  BoardWatch board_;
  FaultBook faults_;
  Joints joints_;

  State state_ = State::kOffline;
  bool in_place_ = false;           // this session starts without a move to the start pose
  bool holds_only_ = false;         // this session has left the robot holding: nothing is taken over or moved any more
  bool started_ = false;            // this session's start is complete
  SafeCommands::Mask polling_;      // joints polled by the last commands; torque is switched on for these only
  int polling_for_ = 0;             // cycles with a reply of the board in which the servos' torque is not yet known
  bool holding_up_ = false;         // torque was switched on here and not off since
  bool perhaps_held_ = true;        // not every servo was seen limp since torque off was sent, or since the start
  bool lost_under_torque_ = false;  // servo power was lost in the newest image while joints were held
  Nanos taking_over_for_{0};
  PoseMove move_;
  PoseMove::Progress progress_ = PoseMove::Progress::kMoving;
  Nanos sat_for_{0};

  SafetyReport report_{};
};

}  // namespace darwinop::safety
