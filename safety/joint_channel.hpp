// One joint's way from limp to driven: confirm where it is, put the goal there, switch torque on, catch up gently.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "core/safe_commands.hpp"
#include "core/sensors.hpp"
#include "safety/config.hpp"
#include "safety/joint_limiter.hpp"

namespace darwinop::safety {

/// Believes a position when two readings in a row agree: one corrupted reading must never become a goal.
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
  // So far may a joint lag behind its goal (rad); at P gain 4 it lags 0.1 rad at the gentle speed.
  static constexpr double kCaughtUp = 0.15;
  // A weight may hold a joint off its goal; it is not kept gentle for ever.
  static constexpr Nanos kHeldUp{std::chrono::seconds{3}};

 public:
  enum class Phase : std::uint8_t {
    kOut,         // gets nothing
    kConfirming,  // wanted, but where it is is not certain yet
    kPlaced,      // its goal was put where it is; torque comes on when the servo is seen to have it
    kGentle,      // driven at the gentle speed until goal and joint have caught up with what is wanted
    kFree,        // driven
  };

  void leaveOut() noexcept { phase_ = Phase::kOut; }
  /// From anywhere: readings from now on decide where it is.
  void restart() noexcept;
  /// Once a cycle, with the reading of the cycle before.
  void observe(const JointSensors& seen, Nanos dt) noexcept {
    if (phase_ == Phase::kConfirming) confirmer_.update(seen);
    if (seen.motion.fresh()) seen_ = seen.position;
    if (moving()) driven_for_ += dt;
  }

  [[nodiscard]] bool ready() const noexcept { return phase_ == Phase::kConfirming && confirmer_.confirmed(); }
  /// Goal := present, moved into the range if it is outside. ready() must hold.
  void place(const JointRange& range) noexcept;
  void torqueOn() noexcept;
  /// One cycle towards `target`. Returns false when the step was cut short.
  bool advance(Rad target, double gentle_step, double full_step) noexcept {
    goal_ = stepTowards(goal_, target, gentle() ? gentle_step : full_step);
    if (goal_ != target) return false;
    // A joint that is held, or that came from outside its range, is still on its way when its goal has arrived.
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
  /// It has a goal that is, or will be, on the wire.
  [[nodiscard]] bool hasGoal() const noexcept { return placed() || moving(); }
  [[nodiscard]] Rad goal() const noexcept { return goal_; }
  /// Time since torque was switched on; nothing while it is off.
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
