// Takeover of one joint, from limp to driven: confirm its position, place the goal there, switch torque on, approach
// the requested goal gently.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/joint_limiter.hpp"

namespace darwinop::safety {

/// Accepts a position if two readings in a row agree: one corrupted reading must never become a goal.
class PositionConfirmer {
 public:
  void forget() noexcept { *this = PositionConfirmer{}; }
  void update(const JointSensors& seen) noexcept;
  [[nodiscard]] std::optional<Rad> confirmed() const noexcept { return confirmed_; }

 private:
  Rad last_;
  std::uint32_t missed_ = 0;
  std::optional<Rad> confirmed_;
};

class JointChannel {
  // Maximum lag of a joint that has caught up, rad; at P gain 4 a joint lags 0.1 rad at the gentle speed.
  static constexpr double kCaughtUp = 0.15;
  // Maximum time at the gentle speed: under load a joint may never reach its goal.
  static constexpr Nanos kHeldUp{std::chrono::seconds{3}};

 public:
  enum class Phase : std::uint8_t {
    kOut,         // nothing is sent
    kConfirming,  // position not confirmed yet
    kPlaced,      // goal = position; torque is switched on once a poll shows the goal in the servo
    kGentle,      // driven at the gentle speed until goal and joint have reached the target
    kFree,        // driven
  };

  void leaveOut() noexcept { phase_ = Phase::kOut; }
  /// Allowed in any phase: confirms the position again, from new readings.
  void restart() noexcept;
  /// Once a cycle, with the reading of the previous cycle.
  void observe(const JointSensors& seen, Nanos dt) noexcept {
    if (phase_ == Phase::kConfirming) confirmer_.update(seen);
    if (seen.motion.fresh()) seen_ = seen.position;
    if (moving()) driven_for_ += dt;
  }

  [[nodiscard]] bool ready() const noexcept { return phase_ == Phase::kConfirming && confirmer_.confirmed(); }
  /// Sets the goal to the confirmed position, clamped to `range`. Requires ready().
  void place(const JointRange& range) noexcept;
  void torqueOn() noexcept;
  /// One step towards `target`, rad. Returns false if the step limit applied.
  bool advance(Rad target, double gentle_step, double full_step) noexcept {
    goal_ = stepTowards(goal_, target, gentle() ? gentle_step : full_step);
    if (goal_ != target) return false;
    // A joint that is blocked, or started outside its range, may lag after its goal has arrived.
    const bool there = std::abs(seen_.value - goal_.value) <= kCaughtUp;
    if (there || driven_for_ >= kHeldUp) phase_ = Phase::kFree;
    return true;
  }

  [[nodiscard]] Phase phase() const noexcept { return phase_; }
  [[nodiscard]] bool out() const noexcept { return phase_ == Phase::kOut; }
  [[nodiscard]] bool placed() const noexcept { return phase_ == Phase::kPlaced; }
  /// Torque is on.
  [[nodiscard]] bool moving() const noexcept { return phase_ == Phase::kGentle || phase_ == Phase::kFree; }
  [[nodiscard]] bool gentle() const noexcept { return phase_ != Phase::kFree; }
  /// Has a goal that was or will be sent.
  [[nodiscard]] bool hasGoal() const noexcept { return placed() || moving(); }
  [[nodiscard]] Rad goal() const noexcept { return goal_; }
  /// Time since torque was switched on; empty while it is off.
  [[nodiscard]] std::optional<Nanos> drivenFor() const noexcept {
    return moving() ? std::optional{driven_for_} : std::nullopt;
  }

 private:
  Phase phase_ = Phase::kOut;
  PositionConfirmer confirmer_;
  Rad goal_, seen_;
  Nanos driven_for_{0};
};

}  // namespace darwinop::safety
